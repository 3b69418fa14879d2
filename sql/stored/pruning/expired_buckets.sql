-- Expired buckets: rows of buckets that go: hidden by a later run or left by one that never finished,
-- older than the horizon, or of a version that goes.
-- Reads:  pruned_versions, horizons, stored_bucket, stored_visible_bucket, stored_run, stored_finished_run
-- A row:  one row of a bucket, by its key.
-- Slots:  :unfinished_from, :unfinished_to  runs in this range may still be at work, unless a later one of
--         their version has finished: then they will be refused
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id
FROM stored_bucket AS written
JOIN pruned_versions AS pruned ON pruned.version_id = written.version_id
LEFT JOIN (
  SELECT
    visible.version_id AS version_id,
    visible.bucket_no AS bucket_no,
    visible.run_id AS run_id,
    1 AS hit
  FROM stored_visible_bucket AS visible
  JOIN horizons AS horizon ON horizon.version_id = visible.version_id
  WHERE visible.bucket_no >= horizon.first_bucket
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
