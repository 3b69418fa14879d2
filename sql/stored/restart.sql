-- Restart: the last bucket that stays: the one before the first that late rows may still change, because it
-- ends within lookback of the newest one, or at or after the instant that the user wants to be repaired from.
-- Reads:  stored_visible_bucket, newest
-- A row:  one version that has a bucket; last_staying is -1 where none stays.
-- Slots:  :lookback     in the unit of time; 2^62 for all there is
--         :repair_from  an instant; 2^62 for none
SELECT bucket.version_id AS version_id, MIN(bucket.bucket_no) - 1 AS last_staying
FROM stored_visible_bucket AS bucket
JOIN newest AS ending ON ending.version_id = bucket.version_id
WHERE bucket.last_time >= ending.newest_time - :lookback OR bucket.last_time >= :repair_from
GROUP BY bucket.version_id
