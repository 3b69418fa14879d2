-- Pending runs: versions whose judgements of late no episode has followed, and from which bucket on: a script appended
-- them.
-- Reads:  stored_run
-- A row:  one version.
-- Slots:  :among  a condition on run, which versions are asked for
--         :near   the same of runs that may matter
SELECT run.version_id AS version_id, MIN(run.from_bucket) AS from_bucket
FROM stored_run AS run
LEFT JOIN (
  SELECT run.version_id AS version_id, MAX(run.run_id) AS run_id, 1 AS hit
  FROM stored_run AS run
  WHERE run.episodes_pending IS NULL AND :among AND :near
  GROUP BY run.version_id
) AS followed ON followed.version_id = run.version_id
WHERE run.episodes_pending = 1
  AND :among
  AND :near
  AND CASE WHEN followed.hit = 1 AND followed.run_id > run.run_id THEN 0 ELSE 1 END = 1
GROUP BY run.version_id
