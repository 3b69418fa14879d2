-- Recorded: the last bucket that stays, as the newest run that read anything recorded it: no bucket is looked
-- at. It holds for late rows up to the lookback of that run; who allows for later ones has to search (restart).
-- Reads:  stored_finished_run
-- A row:  one version of which that is known; last_staying is -1 where none stays, and the times are NULL.
-- Slots:  :at_least  lookback that the run must have allowed for, in the unit of time
--         :since     the first run that is looked at
SELECT
  run.version_id AS version_id,
  0 AS oldest_bucket,
  run.settled_bucket AS last_staying,
  run.settled_time AS last_time,
  run.settled_context AS context_time
FROM stored_finished_run AS run
JOIN (
  SELECT version_id, MAX(run_id) AS newest_id
  FROM stored_finished_run
  WHERE settled_bucket IS NOT NULL AND run_id >= :since
  GROUP BY version_id
) AS reading ON reading.version_id = run.version_id AND reading.newest_id = run.run_id
WHERE run.lookback >= :at_least
