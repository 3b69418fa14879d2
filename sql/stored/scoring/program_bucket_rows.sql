-- Program bucket rows: bucket rows where states are of programs: what a run appends to the stored buckets, with the readings whose program is
-- not judged.
-- Reads:  plain_bucket_rows, unknown_programs
-- A row:  one bucket.
SELECT
  bucket.version_id AS version_id,
  bucket.bucket_no AS bucket_no,
  bucket.run_id AS run_id,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.context_time AS context_time,
  bucket.samples AS samples,
  bucket.still AS still,
  bucket.novel AS novel,
  bucket.out_of_range AS out_of_range,
  bucket.novel_in_window AS novel_in_window,
  CASE WHEN ran.hit = 1 THEN ran.readings ELSE CAST(0 AS BIGINT) END AS unknown_program
FROM plain_bucket_rows AS bucket
LEFT JOIN (
  SELECT version_id, bucket_no, CAST(SUM(part.readings) AS BIGINT) AS readings, 1 AS hit
  FROM unknown_programs AS part
  GROUP BY version_id, bucket_no
) AS ran ON ran.version_id = bucket.version_id AND ran.bucket_no = bucket.bucket_no
ORDER BY bucket.version_id, bucket.bucket_no
