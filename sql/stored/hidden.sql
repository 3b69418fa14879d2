-- Hidden: rows of earlier runs that a committed run has replaced (state.md, publication), among those that
-- were appended: the buckets, or the novel cells.
-- Reads:  appended, stored_run
-- A row:  one such row, by what names it.
-- Slots:  :run_id
--         :after   an instant before all that the run has replaced
SELECT
  earlier.version_id AS version_id,
  earlier.bucket_no AS bucket_no,
  earlier.run_id AS run_id
FROM appended AS earlier
JOIN stored_run AS newer ON newer.version_id = earlier.version_id
WHERE newer.run_id = :run_id
  AND earlier.run_id < newer.run_id
  AND earlier.bucket_no >= newer.from_bucket
  AND earlier.last_time > :after
