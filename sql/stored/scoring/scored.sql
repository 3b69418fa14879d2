-- Scored: what a run read of each channel of a cohort, and how many buckets it writes.
-- Reads:  cohort, seen, new_counts
-- A row:  one channel; read_to is NULL where nothing was read.
SELECT
  member.asset AS asset,
  member.channel AS channel,
  member.first_bucket AS first_bucket,
  CASE WHEN fresh.hit = 1 THEN fresh.new_buckets ELSE CAST(0 AS BIGINT) END AS buckets,
  member.read_from AS read_from,
  CASE WHEN ranged.hit = 1 THEN ranged.read_to END AS read_to,
  CASE WHEN ranged.hit = 1 THEN ranged.rows_read ELSE CAST(0 AS BIGINT) END AS rows_read,
  CASE WHEN ranged.hit = 1 THEN ranged.context_rows ELSE CAST(0 AS BIGINT) END AS context_rows,
  member.context_expected AS context_expected,
  member.planned_from AS planned_from
FROM cohort AS member
LEFT JOIN (
  SELECT channel_id, read_to, rows_read, context_rows, 1 AS hit
  FROM seen
) AS ranged ON ranged.channel_id = member.channel_id
LEFT JOIN (
  SELECT channel_id, new_buckets, 1 AS hit
  FROM new_counts
) AS fresh ON fresh.channel_id = member.channel_id
