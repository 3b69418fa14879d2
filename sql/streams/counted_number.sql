-- Counted number, in stored order: that of a vector, from 1, among the rows that count. For DuckDB, which numbers rows
-- as they come. Proof: that of the vectors (streams/vectors.sql): where a row is marked, all is done again.
CAST(ROW_NUMBER() OVER () AS BIGINT)
