-- Past counts: how many buckets of the window before a run's first one are there.
-- Reads:  past_buckets
-- A row:  one channel that has any.
SELECT channel_id, CAST(COUNT(*) AS BIGINT) AS past_buckets
FROM past_buckets
GROUP BY channel_id
