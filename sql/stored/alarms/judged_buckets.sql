-- Judged buckets: those of the judgements that a run makes: what it wrote, and what stays before that.
-- Reads:  judged_until, new_buckets, stamp, stored_visible_bucket
-- A row:  one bucket.
-- Slots:  :buckets  W / stride, the buckets of a window
--         :near     a condition on bucket that holds for all of them
SELECT
  part.channel_id AS channel_id,
  bucket.bucket_no AS bucket_no,
  bucket.run_id AS run_id,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.novel AS novel
FROM stored_visible_bucket AS bucket
JOIN judged_until AS part ON part.version_id = bucket.version_id
WHERE bucket.bucket_no < part.first_bucket
  AND bucket.bucket_no >= part.first_judgement * :buckets
  AND :near
UNION ALL
SELECT
  part.channel_id AS channel_id,
  bucket.bucket_no AS bucket_no,
  stamp.run_id AS run_id,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.novel AS novel
FROM new_buckets AS bucket
JOIN judged_until AS part ON part.channel_id = bucket.channel_id
CROSS JOIN stamp
