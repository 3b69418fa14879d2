-- Names: the machines and signals that the source speaks of, and what it lacks; as source/names.sql, by the
-- slices.
-- Reads:  slices
-- A row:  one (asset, channel) pair, a missing name included, so that it can be counted and refused.
SELECT
  asset,
  channel,
  CAST(SUM(part.readings) AS BIGINT) AS readings,
  CAST(SUM(part.without_time) AS BIGINT) AS without_time,
  CAST(SUM(part.missing_readings) AS BIGINT) AS missing_readings,
  MIN(part.earliest) AS earliest,
  MAX(part.latest) AS latest
FROM slices AS part
GROUP BY asset, channel
