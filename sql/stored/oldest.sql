-- Oldest: where what is stored of each version begins: bucket 0, unless older ones were pruned.
-- Reads:  stored_visible_bucket
-- A row:  one version that has a bucket.
SELECT version_id, MIN(bucket_no) AS oldest_bucket
FROM stored_visible_bucket
GROUP BY version_id
