-- Ahead: the rows of a source that are later than now. They are left out until their time comes.
-- Reads:  readings
-- A row:  one (asset, channel) pair that has such rows; ahead_to is the latest of their times.
-- Slots:  :latest  the latest instant that counts, in integer microseconds
SELECT
  asset,
  channel,
  CAST(COUNT(*) AS BIGINT) AS ahead_rows,
  MAX(time) AS ahead_to
FROM readings
WHERE time > :latest
GROUP BY asset, channel
