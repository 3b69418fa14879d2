-- Cohort: the channels that are scored together, from where on each is read and scored, and how far it is read: up to
-- the newest reading that the look at the source has found. So a row that comes while the run is at work is no
-- further behind what was read than the lookback allows, and the next run reads it.
-- Reads:  plan, names, planned_runs
-- A row:  one channel.
-- Slots:  :lookback   how late a row may come, in the unit of time
--         :until      nothing later is read
--         :recounted  1 where the rows of calibration are counted anew
--         :differs    1 where buckets are written even if they are stored just so
--         :chosen     a condition on frozen: the channels of this cohort
SELECT
  frozen.channel_id AS channel_id,
  frozen.version_id AS version_id,
  frozen.support_id AS support_id,
  frozen.asset AS asset,
  frozen.channel AS channel,
  frozen.tau AS tau,
  frozen.bins AS bins,
  frozen.stride AS stride,
  CAST(
    FLOOR((CAST(frozen.window_length AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(frozen.stride AS DOUBLE)) AS BIGINT
  ) AS buckets,
  frozen.max_gap AS max_gap,
  frozen.lo AS lo,
  frozen.hi AS hi,
  frozen.calibration_end AS calibration_end,
  frozen.first_bucket AS first_bucket,
  frozen.first_scored AS first_scored,
  frozen.read_from AS read_from,
  CASE
    WHEN looked.hit = 1
      THEN CASE WHEN looked.latest < :until THEN looked.latest ELSE CAST(:until AS BIGINT) END
    ELSE frozen.read_from - 1
  END AS read_until,
  frozen.read_until AS last_read,
  frozen.context_expected AS context_expected,
  frozen.oldest_bucket AS oldest_bucket,
  CAST(0 AS BIGINT) AS settled,
  CAST(0 AS BIGINT) AS novel_from,
  CAST(:lookback AS BIGINT) AS lookback,
  CAST(:recounted AS BIGINT) AS recounted,
  CAST(:differs AS BIGINT) AS differs,
  CASE WHEN done.hit = 1 THEN done.newest_run ELSE CAST(0 AS BIGINT) END AS planned_from,
  CASE WHEN done.hit = 1 THEN done.run_rows ELSE CAST(0 AS BIGINT) END AS planned_rows
FROM plan AS frozen
LEFT JOIN (
  SELECT asset, channel, latest, 1 AS hit
  FROM names
  WHERE latest IS NOT NULL
) AS looked ON looked.asset = frozen.asset AND looked.channel = frozen.channel
LEFT JOIN (
  SELECT version_id, newest_run, run_rows, 1 AS hit
  FROM planned_runs
) AS done ON done.version_id = frozen.version_id
WHERE :chosen
