-- Rejudged buckets: those of the versions whose judgements are made again.
-- Reads:  judged_until, stored_visible_bucket
-- A row:  one bucket of one version, which is its own channel here.
SELECT
  part.channel_id AS channel_id,
  bucket.bucket_no AS bucket_no,
  bucket.run_id AS run_id,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.novel AS novel
FROM stored_visible_bucket AS bucket
JOIN judged_until AS part ON part.version_id = bucket.version_id
