-- Restart: the first bucket that late rows may still change: the first that ends within lookback of the
-- newest one, or at or after the instant that the user wants to be repaired from, whichever is earlier.
-- Reads:  stored_visible_bucket, newest
-- A row:  one version that has a bucket.
-- Slots:  :lookback     in the unit of time; 2^62 for all there is
--         :repair_from  an instant; 2^62 for none
SELECT bucket.version_id AS version_id, MIN(bucket.bucket_no) AS from_bucket
FROM stored_visible_bucket AS bucket
JOIN newest AS ending ON ending.version_id = bucket.version_id
WHERE bucket.last_time >= ending.newest_time - :lookback OR bucket.last_time >= :repair_from
GROUP BY bucket.version_id
