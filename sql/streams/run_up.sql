-- Run-up of one channel: from where on it is read so that the first scored vector finds its oldest sample.
-- Reads:  readings
-- A row:  the channel.
-- Slots:  :channel_id, :asset, :channel, :first_scored
--         :span  (m-1) * tau, the samples between oldest and newest
SELECT
  CAST(:channel_id AS INTEGER) AS channel_id,
  MIN(earlier.time) AS read_from,
  CAST(COUNT(*) AS BIGINT) AS context_rows
FROM (
  SELECT time
  FROM readings
  WHERE asset = :asset AND channel = :channel AND time < :first_scored
  ORDER BY time DESC
  LIMIT :span
) AS earlier
