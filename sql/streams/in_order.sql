-- In order: 1 if each row of a channel is later than the one that is stored before it; a column of streams/names.sql.
-- For DuckDB, which keeps the order of rows. Proof: it is one itself: of n rows, n - 1 are later than the row before
-- only where all are.
CASE
  WHEN CAST(COUNT(CASE WHEN time > previous_time THEN 1 END) AS BIGINT) = CAST(COUNT(*) AS BIGINT) - 1 THEN 1
  ELSE 0
END
