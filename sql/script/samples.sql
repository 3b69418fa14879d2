-- Samples: one value per instant, the smallest; NULL where none is between -1e300 and 1e300.
-- Reads:  readings
SELECT
  asset,
  channel,
  time,
  MIN(number) AS value,
  CASE WHEN MIN(number) < MAX(number) THEN 1 ELSE 0 END AS conflict
FROM (
  SELECT
    asset,
    channel,
    time,
    CASE WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN reading END AS number
  FROM readings
  WHERE time IS NOT NULL AND asset IS NOT NULL AND channel IS NOT NULL
) AS reading
GROUP BY asset, channel, time
