-- Names: the machines and signals that the source speaks of, and what it lacks.
-- Reads:  readings
-- A row:  one (asset, channel) pair, a missing name included, so that it can be counted and refused.
SELECT
  asset,
  channel,
  CAST(COUNT(time) AS BIGINT) AS readings,
  CAST(COUNT(*) AS BIGINT) - CAST(COUNT(time) AS BIGINT) AS without_time,
  CAST(COUNT(*) AS BIGINT) - CAST(
    COUNT(CASE WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN 1 END) AS BIGINT
  ) AS missing_readings,
  MIN(time) AS earliest,
  MAX(time) AS latest
FROM readings
GROUP BY asset, channel
