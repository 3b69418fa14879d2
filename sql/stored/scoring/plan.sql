-- Plan: from where on each version has to be read and scored. Every vector after the last bucket that stays
-- has all its samples at or after that bucket's context_time, so nothing older is read, and nothing is
-- searched for: (m-1) tau samples up to that bucket's last, or that one alone if m = 1; and still_after - 1 more by
-- which still ones are told. Where a channel has not so many, all of it is read, and no number of them is expected.
-- Where no bucket stays, scoring begins as the version does.
-- Reads:  active, restart, last_reads
-- A row:  one version with a range; restarts = 1 if it is known what of it stays.
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
  frozen.calibration_end AS calibration_end,
  frozen.calibration_readings AS calibration_readings,
  CASE WHEN staying.hit = 1 THEN staying.last_staying + 1 ELSE 0 END AS first_bucket,
  CASE WHEN staying.hit = 1 THEN staying.last_time + 1 ELSE frozen.first_scored END AS first_scored,
  CASE WHEN staying.hit = 1 THEN staying.context_time ELSE frozen.run_up_from END AS read_from,
  CASE
    WHEN staying.hit = 1 AND staying.context_time > CAST(:long_ago AS BIGINT)
      THEN CASE
        WHEN frozen.still_after IS NOT NULL THEN (frozen.m - 1) * frozen.tau + frozen.still_after - 1
        WHEN frozen.m = 1 THEN 1
        ELSE (frozen.m - 1) * frozen.tau
      END
  END AS context_expected,
  CASE WHEN again.hit = 1 THEN again.oldest_bucket ELSE 0 END AS oldest_bucket,
  CASE WHEN again.hit = 1 THEN 1 ELSE 0 END AS restarts,
  CASE WHEN seen.hit = 1 THEN seen.read_until ELSE CAST(:long_ago AS BIGINT) END AS read_until,
  CASE WHEN seen.hit = 1 THEN seen.looked_at ELSE CAST(:long_ago AS BIGINT) END AS looked_at,
  CASE
    WHEN seen.hit = 1 AND seen.counted_at > CAST(:long_ago AS BIGINT) THEN seen.counted_at
    ELSE frozen.created
  END AS counted_at,
  frozen.program_column AS program_column
FROM active AS frozen
LEFT JOIN (
  SELECT version_id, oldest_bucket, 1 AS hit
  FROM restart
) AS again ON again.version_id = frozen.version_id
LEFT JOIN (
  SELECT version_id, last_staying, last_time, context_time, 1 AS hit
  FROM restart
  WHERE last_staying >= 0
) AS staying ON staying.version_id = frozen.version_id
LEFT JOIN (
  SELECT version_id, read_until, looked_at, counted_at, 1 AS hit
  FROM last_reads
) AS seen ON seen.version_id = frozen.version_id
WHERE frozen.lo IS NOT NULL
