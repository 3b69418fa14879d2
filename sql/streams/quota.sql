-- Quota of one channel: the instant of its quota-th sample, by the order in which it is stored. That it is so
-- shows afterwards: as many samples must lie up to it.
-- Reads:  readings
-- A row:  the channel.
-- Slots:  :channel_id, :asset, :channel
--         :before  samples before that one
SELECT CAST(:channel_id AS INTEGER) AS channel_id, MAX(reached.time) AS quota_time
FROM (
  SELECT time
  FROM readings
  WHERE asset = :asset AND channel = :channel
  LIMIT 1
  OFFSET :before
) AS reached
