-- Own: what a list of the row of rounds says of the channel whose turn it is. For DuckDB, which has lists. Proof:
-- in_turn (rounds/codes.sql).
-- Dialect: duckdb
-- Slots:  :listed  the list
LIST_EXTRACT(:listed, place)
