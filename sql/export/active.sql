-- Active, dbt form: the channels that are scored, with all that scoring must know of them. The only version
-- of a channel goes by the channel's number.
-- Reads:  stored_channel, stored_bounds
-- A row:  one channel that has a range.
-- Slots:  :window, :stride  W and the length of a bucket, in vectors
SELECT
  known.channel_id AS version_id,
  known.channel_id AS channel_id,
  known.asset AS asset,
  known.channel AS channel,
  known.support_id AS support_id,
  scale.calibrated_lo AS lo,
  scale.calibrated_hi AS hi,
  CAST(:window AS BIGINT) AS window_length,
  CAST(:stride AS BIGINT) AS stride,
  known.calibration_end AS calibration_end,
  known.first_scored AS first_scored,
  known.run_up_from AS run_up_from
FROM stored_channel AS known
JOIN stored_bounds AS scale ON scale.support_id = known.support_id
WHERE scale.calibrated_lo IS NOT NULL
