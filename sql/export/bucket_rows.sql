-- Bucket rows: full buckets of scored vectors, with the two integers of the health indicator (Eq. 2). The
-- first build scores everything; a later one begins at the first bucket that late rows may still change, and
-- writes it and all after it anew.
-- Reads:  new_buckets, bucket_counts
-- A row:  one bucket.
SELECT
  bucket.channel_id AS channel_id,
  bucket.bucket_no AS bucket_no,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.context_time AS context_time,
  bucket.samples AS samples,
  bucket.novel AS novel,
  bucket.out_of_range AS out_of_range,
  counted.novel_in_window AS novel_in_window,
  CAST(counted.window_length AS BIGINT) AS window_length
FROM new_buckets AS bucket
JOIN bucket_counts AS counted
  ON counted.channel_id = bucket.channel_id AND counted.bucket_no = bucket.bucket_no
