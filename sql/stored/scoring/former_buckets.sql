-- Former buckets: what is stored of those that a run, or the check of the state, makes anew.
-- Reads:  stored_visible_bucket, stored_bucket, cohort
-- A row:  one bucket.
-- Slots:  :near    a condition on bucket that holds for all of them
--         :within  the same of single rows, in literals, by which an index finds them
--         :programs  unknown_program, where states are of programs
SELECT
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  bucket.bucket_no AS bucket_no,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time,
  bucket.context_time AS context_time,
  bucket.samples AS samples,
  written.still AS still,
  :programs,
  bucket.novel AS novel,
  bucket.out_of_range AS out_of_range,
  bucket.novel_in_window AS novel_in_window
FROM stored_visible_bucket AS bucket
JOIN (
  SELECT version_id, bucket_no, run_id, still, :programs
  FROM stored_bucket AS bucket
  WHERE :within
) AS written
  ON written.version_id = bucket.version_id
  AND written.bucket_no = bucket.bucket_no
  AND written.run_id = bucket.run_id
JOIN cohort AS member ON member.version_id = bucket.version_id
WHERE bucket.bucket_no >= member.first_bucket
  AND :near
