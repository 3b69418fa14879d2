-- Misplaced: whether a row is not of the channel whose turn it is, or not later than the one a round before. For
-- DuckDB, where vectors follow the order of rows. Proof: it is the one of rounds/vectors.sql.
-- Slots:  :previous_time  the instant of that one
in_turn = 0 OR time <= :previous_time
