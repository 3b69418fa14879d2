-- Names, one channel: what the source has of it; as source/names.sql. For DuckDB, which leaves out most rows of other
-- channels where they lie apart: counted one by one, they need no grouping of all rows by two texts. Proof: all
-- channels together have as many rows as the source.
-- Reads:  readings
-- A row:  the channel.
-- Slots:  :asset, :channel
--         :proof  streams/in_order.sql where it is asked for
SELECT
  CAST(COUNT(time) AS BIGINT) AS readings,
  CAST(COUNT(*) AS BIGINT) - CAST(COUNT(time) AS BIGINT) AS without_time,
  CAST(COUNT(*) AS BIGINT) - CAST(
    COUNT(CASE WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN 1 END) AS BIGINT
  ) AS missing_readings,
  MIN(time) AS earliest,
  MAX(time) AS latest,
  :proof
FROM (
  SELECT time, reading, LAG(time, 1) OVER () AS previous_time
  FROM readings
  WHERE asset = :asset AND channel = :channel
) AS stored
