-- Counted: the versions that are read, and whether the rows of their calibration are counted anew. That is due once a
-- day, and where the last look was while the clock stood ahead; who is read alike is counted together.
-- Reads:  begun, clock
-- A row:  one version.
-- Slots:  :day  microseconds of a day
SELECT
  version_id,
  channel_id,
  asset,
  channel,
  support_id,
  lo,
  hi,
  m,
  tau,
  bins,
  window_length,
  stride,
  max_gap,
  still_after,
  score_from,
  program_column,
  calibration_end,
  read_until,
  first_bucket,
  first_scored,
  read_from,
  context_expected,
  oldest_bucket,
  MAX(is_due) OVER (PARTITION BY part_no) AS recounted
FROM (
  SELECT
    part.version_id AS version_id,
    part.channel_id AS channel_id,
    part.asset AS asset,
    part.channel AS channel,
    part.support_id AS support_id,
    part.lo AS lo,
    part.hi AS hi,
    part.m AS m,
    part.tau AS tau,
    part.bins AS bins,
    part.window_length AS window_length,
    part.stride AS stride,
    part.max_gap AS max_gap,
    part.still_after AS still_after,
    part.score_from AS score_from,
    part.program_column AS program_column,
    part.calibration_end AS calibration_end,
    part.read_until AS read_until,
    part.first_bucket AS first_bucket,
    part.first_scored AS first_scored,
    part.read_from AS read_from,
    part.context_expected AS context_expected,
    part.oldest_bucket AS oldest_bucket,
    part.part_no AS part_no,
    CASE
      WHEN part.looked_at > watch.started THEN 1
      WHEN part.counted_at <= watch.started AND watch.started - part.counted_at < :day THEN 0
      ELSE 1
    END AS is_due
  FROM begun AS part
  CROSS JOIN clock AS watch
) AS due
