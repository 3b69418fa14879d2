-- Cohort, dbt form: the channels that are scored, and from where on each is read and scored in this build. Every
-- vector after the last bucket that stays has all its samples at or after that bucket's context_time.
-- Reads:  stored_channel, stored_bounds, restart
-- A row:  one channel that has a range.
-- Slots:  :far_ahead  an instant after all others
SELECT
  frozen.channel_id AS version_id,
  frozen.channel_id AS channel_id,
  frozen.asset AS asset,
  frozen.channel AS channel,
  frozen.support_id AS support_id,
  scale.calibrated_lo AS lo,
  scale.calibrated_hi AS hi,
  frozen.calibration_end AS calibration_end,
  CASE WHEN staying.hit = 1 THEN staying.bucket_no + 1 ELSE 0 END AS first_bucket,
  CASE WHEN staying.hit = 1 THEN staying.last_time + 1 ELSE frozen.first_scored END AS first_scored,
  CASE WHEN staying.hit = 1 THEN staying.context_time ELSE frozen.run_up_from END AS read_from,
  CAST(:far_ahead AS BIGINT) AS read_until
FROM stored_channel AS frozen
JOIN stored_bounds AS scale ON scale.support_id = frozen.support_id
LEFT JOIN (
  SELECT channel_id, bucket_no, last_time, context_time, 1 AS hit
  FROM restart
) AS staying ON staying.channel_id = frozen.channel_id
WHERE scale.calibrated_lo IS NOT NULL
