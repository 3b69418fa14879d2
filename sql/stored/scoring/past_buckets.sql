-- Past buckets: the last window of buckets that stay, for the running counts of those that follow.
-- Reads:  stored_visible_bucket, cohort
-- A row:  one bucket.
-- Slots:  :buckets    W / stride, the buckets of a window
--         :differing  the column buckets where channels differ in it; none where all share it
--         :near       a condition on bucket that holds for all of them
SELECT
  member.channel_id AS channel_id,
  :differing,
  bucket.bucket_no AS bucket_no,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.novel AS novel,
  bucket.out_of_range AS out_of_range
FROM stored_visible_bucket AS bucket
JOIN cohort AS member ON member.version_id = bucket.version_id
WHERE bucket.bucket_no < member.first_bucket
  AND bucket.bucket_no >= member.first_bucket - :buckets
  AND :near
