-- Whole cohort: each channel is read and scored from its first vector on.
-- Reads:  active
-- A row:  one channel.
-- Slots:  :far_ahead  an instant after all others
SELECT
  frozen.version_id AS version_id,
  frozen.channel_id AS channel_id,
  frozen.asset AS asset,
  frozen.channel AS channel,
  frozen.support_id AS support_id,
  frozen.lo AS lo,
  frozen.hi AS hi,
  frozen.calibration_end AS calibration_end,
  CAST(0 AS BIGINT) AS first_bucket,
  frozen.first_scored AS first_scored,
  frozen.run_up_from AS read_from,
  CAST(:far_ahead AS BIGINT) AS read_until
FROM active AS frozen
