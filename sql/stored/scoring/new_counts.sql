-- New counts: how many buckets a run has made of each channel.
-- Reads:  new_buckets
-- A row:  one channel that has a new bucket.
SELECT made.channel_id AS channel_id, CAST(COUNT(*) AS BIGINT) AS new_buckets
FROM new_buckets AS made
GROUP BY made.channel_id
