-- Known channels: those of a monitor that have a number.
-- Reads:  stored_channel
-- A row:  one channel.
-- Slots:  :monitor_id
SELECT
  known.channel_id AS channel_id,
  known.asset AS asset,
  known.channel AS channel
FROM stored_channel AS known
WHERE known.monitor_id = :monitor_id
