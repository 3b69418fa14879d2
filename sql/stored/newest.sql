-- Newest: the end of what is stored of each version; there is no other watermark.
-- Reads:  stored_visible_bucket, active
-- A row:  one version that has a bucket.
SELECT bucket.version_id AS version_id, MAX(bucket.last_time) AS newest_time
FROM stored_visible_bucket AS bucket
JOIN active AS frozen ON frozen.version_id = bucket.version_id
GROUP BY bucket.version_id
