-- Counts, in stored order: whether a sample ends a vector in which none is missing. For DuckDB, by streams/vectors.sql.
-- Proof: none is needed.
whole = 1 AND cell_key IS NOT NULL
