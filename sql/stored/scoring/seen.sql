-- Seen: what was read of each channel. The samples before the first vector to be scored are context; there
-- must be exactly (m-1) tau of them, else rows came or went behind the lookback.
-- Reads:  samples, timeline, cohort
-- A row:  one channel that has a sample in its range; repeats counts the rows beyond the first of an instant.
SELECT
  member.channel_id AS channel_id,
  CAST(COUNT(*) AS BIGINT) + MIN(clock.repeats) AS rows_read,
  CAST(SUM(CASE WHEN sampled.time < member.first_scored THEN 1 ELSE 0 END) AS BIGINT) AS context_rows,
  CAST(SUM(CASE WHEN sampled.value IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS missing_samples,
  MAX(sampled.time) AS read_to
FROM samples AS sampled
JOIN cohort AS member ON member.channel_id = sampled.channel_id
JOIN timeline AS clock ON clock.channel_id = sampled.channel_id
GROUP BY member.channel_id
