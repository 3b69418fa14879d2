-- Monitor channels: the channels of a monitor that have a number.
-- Reads:  stored_channel
-- A row:  one channel.
-- Slots:  :monitor_id
SELECT
  channel_row.channel_id AS channel_id,
  channel_row.asset AS asset,
  channel_row.channel AS channel
FROM stored_channel AS channel_row
WHERE channel_row.monitor_id = :monitor_id
