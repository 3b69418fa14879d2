-- Bucket rows: what a run appends to the stored buckets, with the two integers of Eq. 2.
-- Reads:  new_buckets, bucket_counts, stamp
-- A row:  one bucket.
SELECT
  made.version_id AS version_id,
  made.bucket_no AS bucket_no,
  stamp.run_id AS run_id,
  made.first_time AS first_time,
  made.last_time AS last_time,
  made.context_time AS context_time,
  made.samples AS samples,
  made.novel AS novel,
  made.out_of_range AS out_of_range,
  counted.novel_in_window AS novel_in_window
FROM new_buckets AS made
JOIN bucket_counts AS counted
  ON counted.channel_id = made.channel_id AND counted.bucket_no = made.bucket_no
CROSS JOIN stamp
ORDER BY made.version_id, made.bucket_no
