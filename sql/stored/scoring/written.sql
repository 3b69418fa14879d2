-- Written: the buckets that a run writes, of those that it has made.
-- Reads:  new_buckets, changed
-- A row:  one bucket.
SELECT
  bucket.channel_id AS channel_id,
  bucket.version_id AS version_id,
  bucket.bucket_no AS bucket_no,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.context_time AS context_time,
  bucket.samples AS samples,
  bucket.novel AS novel,
  bucket.out_of_range AS out_of_range
FROM new_buckets AS bucket
JOIN changed AS part ON part.channel_id = bucket.channel_id
WHERE bucket.bucket_no >= part.first_bucket
