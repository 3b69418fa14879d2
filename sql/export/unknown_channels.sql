-- Unknown channels: those that have rows at the time of calibration, and had none when the package was first
-- built. They are scored after a full refresh.
-- Reads:  names, stored_channel
-- A row:  one such channel.
SELECT
  source_name.asset AS asset,
  source_name.channel AS channel,
  source_name.readings AS readings
FROM names AS source_name
LEFT JOIN (
  SELECT asset, channel, 1 AS hit
  FROM stored_channel
) AS channel_row ON channel_row.asset = source_name.asset AND channel_row.channel = source_name.channel
WHERE source_name.readings > 0
  AND source_name.asset IS NOT NULL
  AND source_name.channel IS NOT NULL
  AND CASE WHEN channel_row.hit = 1 THEN 0 ELSE 1 END = 1
