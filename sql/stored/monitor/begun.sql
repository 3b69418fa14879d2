-- Begun: from where on each version is read and scored. Where its context has left the source, that is the first bucket
-- whose context is there whole, with its stored number; where there is none, no number of samples is expected.
-- Reads:  plan, wanted, whole_plan, whole, oldest_rows, active
-- A row:  one version that is read.
-- Slots:  :long_ago  an instant before all others
SELECT
  frozen.version_id AS version_id,
  frozen.channel_id AS channel_id,
  frozen.asset AS asset,
  frozen.channel AS channel,
  frozen.support_id AS support_id,
  frozen.lo AS lo,
  frozen.hi AS hi,
  frozen.m AS m,
  frozen.tau AS tau,
  frozen.bins AS bins,
  frozen.window_length AS window_length,
  frozen.stride AS stride,
  frozen.max_gap AS max_gap,
  frozen.still_after AS still_after,
  frozen.score_from AS score_from,
  frozen.program_column AS program_column,
  frozen.calibration_end AS calibration_end,
  frozen.read_until AS read_until,
  frozen.looked_at AS looked_at,
  frozen.counted_at AS counted_at,
  part.part_no AS part_no,
  CASE WHEN staying.hit = 1 THEN staying.first_bucket ELSE frozen.first_bucket END AS first_bucket,
  CASE WHEN staying.hit = 1 THEN staying.first_scored ELSE frozen.first_scored END AS first_scored,
  CASE WHEN staying.hit = 1 THEN staying.read_from ELSE frozen.read_from END AS read_from,
  CASE WHEN staying.hit = 1 THEN staying.context_expected ELSE frozen.context_expected END AS context_expected,
  CASE WHEN staying.hit = 1 THEN staying.oldest_bucket ELSE frozen.oldest_bucket END AS oldest_bucket
FROM plan AS frozen
JOIN wanted AS part ON part.version_id = frozen.version_id
LEFT JOIN (
  SELECT
    again.version_id AS version_id,
    again.first_bucket AS first_bucket,
    again.first_scored AS first_scored,
    again.read_from AS read_from,
    CASE WHEN again.read_from >= gone.oldest_time THEN again.context_expected END AS context_expected,
    again.oldest_bucket AS oldest_bucket,
    1 AS hit
  FROM whole_plan AS again
  JOIN oldest_rows AS gone ON gone.version_id = again.version_id
  JOIN whole AS ending ON ending.version_id = again.version_id
  JOIN active AS version ON version.version_id = again.version_id
  JOIN plan AS planned ON planned.version_id = again.version_id
  WHERE again.first_bucket >= planned.first_bucket
    AND gone.oldest_time
    > CASE WHEN version.run_up_from > CAST(:long_ago AS BIGINT) THEN version.run_up_from ELSE ending.begin_time END
) AS staying ON staying.version_id = frozen.version_id
