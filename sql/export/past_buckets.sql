-- Past buckets, dbt form: the last window of buckets that stay, for the running counts of those that follow.
-- Reads:  earlier_bucket, cohort
-- A row:  one bucket.
-- Slots:  :buckets  W / stride, the buckets of a window
SELECT
  member.channel_id AS channel_id,
  former.bucket_no AS bucket_no,
  former.novel AS novel
FROM earlier_bucket AS former
JOIN cohort AS member ON member.channel_id = former.channel_id
WHERE former.bucket_no < member.first_bucket AND former.bucket_no >= member.first_bucket - :buckets
