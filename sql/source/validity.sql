-- Validity: for how many rows of each channel the user's condition on readings does not hold; here a reading is 1 where it
-- holds, else 0.
-- Reads:  readings
-- A row:  one (asset, channel) pair; all of its rows count.
SELECT
  asset,
  channel,
  CAST(COUNT(*) AS BIGINT) AS readings,
  CAST(COUNT(CASE WHEN reading < 1 THEN 1 END) AS BIGINT) AS invalid
FROM readings
GROUP BY asset, channel
