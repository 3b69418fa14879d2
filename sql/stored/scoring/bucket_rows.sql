-- Bucket rows: what a run appends to the stored buckets, with the two integers of Eq. 2.
-- Reads:  written, bucket_counts, still_counts, stamp
-- A row:  one bucket; still is NULL where no sample counts as still.
SELECT
  bucket.version_id AS version_id,
  bucket.bucket_no AS bucket_no,
  stamp.run_id AS run_id,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.context_time AS context_time,
  bucket.samples AS samples,
  CASE WHEN calm.hit = 1 THEN calm.still END AS still,
  bucket.novel AS novel,
  bucket.out_of_range AS out_of_range,
  counted.novel_in_window AS novel_in_window
FROM written AS bucket
JOIN bucket_counts AS counted
  ON counted.channel_id = bucket.channel_id AND counted.bucket_no = bucket.bucket_no
LEFT JOIN (
  SELECT channel_id, bucket_no, still, 1 AS hit
  FROM still_counts
) AS calm ON calm.channel_id = bucket.channel_id AND calm.bucket_no = bucket.bucket_no
CROSS JOIN stamp
ORDER BY bucket.version_id, bucket.bucket_no
