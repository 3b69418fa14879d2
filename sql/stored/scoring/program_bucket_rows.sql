-- Bucket rows, where states are of programs: what a run appends to the stored buckets, with the readings whose program is
-- not judged.
-- Reads:  plain_bucket_rows, unknown_programs
-- A row:  one bucket.
SELECT
  made.version_id AS version_id,
  made.bucket_no AS bucket_no,
  made.run_id AS run_id,
  made.first_time AS first_time,
  made.last_time AS last_time,
  made.context_time AS context_time,
  made.samples AS samples,
  made.still AS still,
  made.novel AS novel,
  made.out_of_range AS out_of_range,
  made.novel_in_window AS novel_in_window,
  CASE WHEN ran.hit = 1 THEN ran.readings ELSE CAST(0 AS BIGINT) END AS unknown_program
FROM plain_bucket_rows AS made
LEFT JOIN (
  SELECT version_id, bucket_no, CAST(SUM(part.readings) AS BIGINT) AS readings, 1 AS hit
  FROM unknown_programs AS part
  GROUP BY version_id, bucket_no
) AS ran ON ran.version_id = made.version_id AND ran.bucket_no = made.bucket_no
ORDER BY made.version_id, made.bucket_no
