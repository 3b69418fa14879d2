-- Validity: for how many rows of each channel the user's condition on readings does not hold.
-- Reads:  readings, with 1 or 0 as the reading: whether it holds
-- A row:  one (asset, channel) pair; all of its rows count.
SELECT
  asset,
  channel,
  CAST(COUNT(*) AS BIGINT) AS readings,
  CAST(COUNT(CASE WHEN reading < 1 THEN 1 END) AS BIGINT) AS invalid
FROM readings
GROUP BY asset, channel
