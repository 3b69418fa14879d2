-- Reached: the run-up of one channel (score/run_up.sql) of which calibration has found the samples already: the last
-- ones up to its quota, which the first scored vector reaches back to.
-- A row:  the channel.
-- Slots:  :channel_id
--         :lo, :hi       its calibrated range
--         :read_from     the instant of the oldest of these samples
--         :context_rows  how many they are
SELECT
  CAST(:channel_id AS INTEGER) AS channel_id,
  :lo AS lo,
  :hi AS hi,
  CAST(:read_from AS BIGINT) AS read_from,
  CAST(:context_rows AS BIGINT) AS context_rows,
  1 AS complete
