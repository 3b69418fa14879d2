-- Past missing: channels of which buckets of the last window before a run's first one are not there.
-- Reads:  cohort, past_buckets
-- A row:  one such channel.
SELECT member.channel_id AS channel_id
FROM cohort AS member
LEFT JOIN (
  SELECT channel_id, CAST(COUNT(*) AS BIGINT) AS past_buckets, 1 AS hit
  FROM past_buckets
  GROUP BY channel_id
) AS past ON past.channel_id = member.channel_id
WHERE CASE WHEN past.hit = 1 THEN past.past_buckets ELSE 0 END
  <> CASE WHEN member.first_bucket < member.buckets THEN member.first_bucket ELSE member.buckets END
