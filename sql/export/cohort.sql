-- Cohort: from where on each channel is read and scored in an incremental build. Every vector after the last
-- bucket that stays has all its samples at or after that bucket's context_time.
-- Reads:  active, restart
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
  CASE WHEN staying.hit = 1 THEN staying.last_staying + 1 ELSE 0 END AS first_bucket,
  CASE WHEN staying.hit = 1 THEN staying.last_time + 1 ELSE frozen.first_scored END AS first_scored,
  CASE WHEN staying.hit = 1 THEN staying.context_time ELSE frozen.run_up_from END AS read_from,
  CAST(:far_ahead AS BIGINT) AS read_until
FROM active AS frozen
LEFT JOIN (
  SELECT version_id, last_staying, last_time, context_time, 1 AS hit
  FROM restart
  WHERE last_staying >= 0
) AS staying ON staying.version_id = frozen.version_id
