-- Finished run: the runs that count. One that was withdrawn has a second row that says so, and neither is
-- here.
CREATE OR REPLACE VIEW stored_finished_run AS
SELECT
  run.run_id AS run_id,
  run.version_id AS version_id,
  run.from_bucket AS from_bucket,
  run.read_from AS read_from,
  run.read_to AS read_to,
  run.rows_read AS rows_read,
  run.context_rows AS context_rows,
  run.context_expected AS context_expected,
  run.calibration_readings AS calibration_readings,
  run.lookback AS lookback,
  run.settled_bucket AS settled_bucket,
  run.settled_time AS settled_time,
  run.settled_context AS settled_context,
  run.started AS started,
  run.committed AS committed,
  run.planned_from AS planned_from
FROM stored_run AS run
LEFT JOIN (
  SELECT version_id, run_id, 1 AS hit
  FROM stored_run
  WHERE withdrawn = 1
) AS gone ON gone.version_id = run.version_id AND gone.run_id = run.run_id
WHERE CASE WHEN gone.hit = 1 THEN 1 ELSE 0 END < 1;

COMMENT ON VIEW stored_finished_run IS 'Finished runs of scoring, but those that were withdrawn';
COMMENT ON COLUMN stored_finished_run.run_id IS 'The run; a later one is larger';
COMMENT ON COLUMN stored_finished_run.version_id IS 'The version';
COMMENT ON COLUMN stored_finished_run.from_bucket IS 'First bucket that it wrote anew';
COMMENT ON COLUMN stored_finished_run.read_from IS 'From which time on it read the channel';
COMMENT ON COLUMN stored_finished_run.read_to
  IS 'Newest time that it read of the channel; NULL if there was no row';
COMMENT ON COLUMN stored_finished_run.rows_read IS 'Rows of the channel that it read';
COMMENT ON COLUMN stored_finished_run.context_rows
  IS 'Samples it read up to the end of the bucket before from_bucket';
COMMENT ON COLUMN stored_finished_run.context_expected
  IS 'Samples there were when that bucket was written; NULL for the first bucket';
COMMENT ON COLUMN stored_finished_run.calibration_readings
  IS 'Rows inside calibration, counted again; NULL if this run did not count';
COMMENT ON COLUMN stored_finished_run.lookback
  IS 'How late a row may come, as this run took it, in the unit of time';
COMMENT ON COLUMN stored_finished_run.settled_bucket
  IS 'Last bucket that no such row can change; -1 if there is none, NULL if no row was read';
COMMENT ON COLUMN stored_finished_run.settled_time
  IS 'Time of its last vector: the next run scores what is newer; NULL if there is none';
COMMENT ON COLUMN stored_finished_run.settled_context
  IS 'Its context_time: the next run reads from there; NULL if there is none';
COMMENT ON COLUMN stored_finished_run.started IS 'When it began, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_finished_run.committed
  IS 'When it was recorded, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_finished_run.planned_from
  IS 'The newest finished run of the version when this one was planned; 0 if there was none';
