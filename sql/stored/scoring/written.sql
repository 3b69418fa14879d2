-- Written: the buckets that a run writes, of those that it has made.
-- Reads:  new_buckets, changed
-- A row:  one bucket.
SELECT
  made.channel_id AS channel_id,
  made.version_id AS version_id,
  made.bucket_no AS bucket_no,
  made.first_time AS first_time,
  made.last_time AS last_time,
  made.context_time AS context_time,
  made.samples AS samples,
  made.novel AS novel,
  made.out_of_range AS out_of_range
FROM new_buckets AS made
JOIN changed AS part ON part.channel_id = made.channel_id
WHERE made.bucket_no >= part.first_bucket
