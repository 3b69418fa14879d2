-- Scored, in stored order: whether a vector may be scored: its newest sample comes after calibration. For DuckDB, where
-- rows before that may be more than a vector takes. Proof: none is needed.
-- Slots:  :first_scored
time >= :first_scored
