-- Collapsed readings: the readings of a source in which an instant occurs twice: the smallest value of each instant
-- that is not missing (method, section 2). The steps run once more over these.
-- Reads:  readings
-- A row:  one instant of one channel; conflict = 1 where it had two different values.
SELECT
  asset,
  channel,
  time,
  MIN(valued.value) AS reading,
  CASE WHEN MIN(valued.value) < MAX(valued.value) THEN 1 ELSE 0 END AS conflict
FROM (
  SELECT
    asset,
    channel,
    time,
    CASE WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN reading END AS value
  FROM readings
  WHERE time IS NOT NULL
) AS valued
GROUP BY asset, channel, time
