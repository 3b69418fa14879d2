-- New counts: how many buckets a run writes of each channel.
-- Reads:  written
-- A row:  one channel of which it writes any.
SELECT bucket.channel_id AS channel_id, CAST(COUNT(*) AS BIGINT) AS new_buckets
FROM written AS bucket
GROUP BY bucket.channel_id
