-- Superseded: rows of earlier runs that a committed run has replaced (state.md, publication), among those that
-- were appended: the buckets, or the novel cells.
-- Reads:  appended, stored_run
-- A row:  one such row, by what names it.
-- Slots:  :run_id
--         :after   an instant before all that the run has replaced
--         :near    a condition on bucket that holds for all of that
SELECT
  bucket.version_id AS version_id,
  bucket.bucket_no AS bucket_no,
  bucket.run_id AS run_id
FROM appended AS bucket
JOIN stored_run AS newer ON newer.version_id = bucket.version_id
WHERE newer.run_id = :run_id
  AND bucket.run_id < newer.run_id
  AND bucket.bucket_no >= newer.from_bucket
  AND bucket.last_time > :after
  AND :near
