-- Run-up of one channel, in stored order: from where on it is read so that the first scored vector finds its oldest
-- sample; see score/run_up.sql.
-- Reads:  readings
-- A row:  the channel.
-- Slots:  :channel_id, :asset, :channel, :first_scored
--         :lo, :hi  its calibrated range
--         :span     (m-1) * tau, the samples between oldest and newest
SELECT
  CAST(:channel_id AS INTEGER) AS channel_id,
  :lo AS lo,
  :hi AS hi,
  COALESCE(MIN(earlier.time), CAST(:first_scored AS BIGINT)) AS read_from,
  CAST(COUNT(*) AS BIGINT) AS context_rows,
  1 AS complete
FROM (
  SELECT time
  FROM readings
  WHERE asset = :asset AND channel = :channel AND time < :first_scored
  ORDER BY time DESC
  LIMIT :span
) AS earlier
