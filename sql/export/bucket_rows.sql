-- Bucket rows: full buckets of scored vectors, with the two integers of the health indicator (Eq. 2). The
-- first build scores everything; a later one begins at the first bucket that late rows may still change, and
-- writes it and all after it anew.
-- Reads:  new_buckets, bucket_counts
-- A row:  one bucket.
SELECT
  made.channel_id AS channel_id,
  made.bucket_no AS bucket_no,
  made.first_time AS first_time,
  made.last_time AS last_time,
  made.context_time AS context_time,
  made.samples AS samples,
  made.novel AS novel,
  made.out_of_range AS out_of_range,
  counted.novel_in_window AS novel_in_window,
  CAST(counted.window_length AS BIGINT) AS window_length
FROM new_buckets AS made
JOIN bucket_counts AS counted
  ON counted.channel_id = made.channel_id AND counted.bucket_no = made.bucket_no
