-- Buckets before: where some buckets end, and from where on a run reads what follows them.
-- Reads:  stored_visible_bucket
-- A row:  one bucket.
-- Slots:  :wanted  a condition on *full_bucket*
SELECT version_id, bucket_no, last_time, context_time
FROM stored_visible_bucket AS full_bucket
WHERE :wanted
