-- Members: the channels that one part of a script is for.
-- Reads:  cohort, counted
-- A row:  one channel.
-- Slots:  :listed  the condition on frozen that it is for them
SELECT
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  member.support_id AS support_id,
  member.asset AS asset,
  member.channel AS channel,
  member.tau AS tau,
  member.bins AS bins,
  member.stride AS stride,
  member.buckets AS buckets,
  member.max_gap AS max_gap,
  member.lo AS lo,
  member.hi AS hi,
  member.calibration_end AS calibration_end,
  member.first_bucket AS first_bucket,
  member.first_scored AS first_scored,
  member.read_from AS read_from,
  member.read_until AS read_until,
  member.last_read AS last_read,
  member.context_expected AS context_expected,
  member.oldest_bucket AS oldest_bucket,
  member.settled AS settled,
  member.novel_from AS novel_from,
  member.lookback AS lookback,
  member.recounted AS recounted,
  member.differs AS differs,
  member.planned_from AS planned_from,
  member.planned_rows AS planned_rows
FROM cohort AS member
JOIN counted AS frozen ON frozen.version_id = member.version_id
WHERE :listed
