-- Last data: how far each channel was read by its newest run that read anything. A row of the future that was taken away
-- again says nothing any more, and no channel speaks for another.
-- Reads:  status_rows, stored_finished_run
-- A row:  one version of which a run read a row.
SELECT
  run.version_id AS version_id,
  run.read_to AS last_data
FROM stored_finished_run AS run
JOIN (
  SELECT done.version_id AS version_id, MAX(done.run_id) AS newest_id
  FROM stored_finished_run AS done
  WHERE done.read_to IS NOT NULL
  GROUP BY done.version_id
) AS reading ON reading.version_id = run.version_id AND reading.newest_id = run.run_id
JOIN status_rows AS status ON status.version_id = run.version_id
WHERE run.read_to IS NOT NULL
