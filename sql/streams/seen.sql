-- Seen, one channel: what is read of it; as stored/scoring/seen.sql. For DuckDB, which leaves out most rows of other
-- channels where they lie apart. Proof: it is asked before the vectors are made and after, and both times says the
-- same.
-- Reads:  readings
-- A row:  the channel, if it has a row in its range.
-- Slots:  :asset, :channel
--         :time_from, :time_to  the instants that are read
--         :first_scored         what lies before it is context
SELECT
  CAST(COUNT(*) AS BIGINT) AS rows_read,
  CAST(SUM(CASE WHEN reading.time < :first_scored THEN 1 ELSE 0 END) AS BIGINT) AS context_rows,
  CAST(
    SUM(CASE WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN 0 ELSE 1 END)
    AS BIGINT
  ) AS missing_samples,
  MAX(reading.time) AS read_to
FROM readings AS reading
WHERE reading.asset = :asset
  AND reading.channel = :channel
  AND reading.time BETWEEN :time_from AND :time_to
HAVING COUNT(*) > 0
