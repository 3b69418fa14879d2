-- Unknown program rows: what a run appends of the readings whose program is not judged, from the bucket on from which it
-- hides what is stored.
-- Reads:  unknown_programs, run_rows
-- A row:  one program in one bucket.
SELECT
  ran.version_id AS version_id,
  ran.bucket_no AS bucket_no,
  recorded.run_id AS run_id,
  ran.program AS program,
  ran.readings AS readings,
  ran.first_time AS first_time,
  ran.last_time AS last_time
FROM unknown_programs AS ran
JOIN run_rows AS recorded ON recorded.version_id = ran.version_id
WHERE ran.bucket_no >= recorded.from_bucket
