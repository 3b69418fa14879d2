-- Former programs: what is stored of the readings whose program is not judged, of buckets that a run, or the check of the
-- state, makes anew.
-- Reads:  stored_visible_program, cohort
-- A row:  one program in one bucket.
-- Slots:  :near  a condition on bucket that holds for all of them
SELECT
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  bucket.bucket_no AS bucket_no,
  bucket.program AS program,
  bucket.readings AS readings,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time
FROM stored_visible_program AS bucket
JOIN cohort AS member ON member.version_id = bucket.version_id
WHERE bucket.bucket_no >= member.first_bucket
  AND :near
