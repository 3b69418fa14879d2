-- Seen, dbt form: the samples of each channel before the first one that is scored in this build.
-- Reads:  samples, cohort
-- A row:  one channel that has a sample in its range.
SELECT
  member.channel_id AS channel_id,
  CAST(SUM(CASE WHEN sampled.time < member.first_scored THEN 1 ELSE 0 END) AS BIGINT) AS context_rows
FROM samples AS sampled
JOIN cohort AS member ON member.channel_id = sampled.channel_id
GROUP BY member.channel_id
