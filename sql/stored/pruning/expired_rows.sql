-- Expired rows, of buckets, of novel cells or of judgements: hidden by a later run or left by one that never
-- finished, older than the horizon, or of a version that goes.
-- Reads:  written_rows, staying_rows, pruned_versions, stored_run, stored_finished_run
-- A row:  all that one run wrote of one bucket, by their key.
-- Slots:  :unfinished_from, :unfinished_to  runs in this range may still be at work, unless a later one of
--         their version has finished: then they will be refused
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id
FROM (
  SELECT DISTINCT version_id, bucket_no, run_id
  FROM written_rows
) AS written
JOIN pruned_versions AS pruned ON pruned.version_id = written.version_id
LEFT JOIN (
  SELECT version_id, bucket_no, run_id, 1 AS hit
  FROM staying_rows
) AS staying
  ON staying.version_id = written.version_id
  AND staying.bucket_no = written.bucket_no
  AND staying.run_id = written.run_id
LEFT JOIN (
  SELECT DISTINCT version_id, run_id, 1 AS hit
  FROM stored_run
) AS finished ON finished.version_id = written.version_id AND finished.run_id = written.run_id
LEFT JOIN (
  SELECT version_id, MAX(run_id) AS newest_id, 1 AS hit
  FROM stored_finished_run
  GROUP BY version_id
) AS latest ON latest.version_id = written.version_id
WHERE CASE
  WHEN staying.hit = 1 THEN 0
  WHEN finished.hit = 1 THEN 1
  WHEN latest.hit = 1 AND latest.newest_id > written.run_id THEN 1
  WHEN written.run_id BETWEEN :unfinished_from AND :unfinished_to THEN 0
  ELSE 1
END = 1
