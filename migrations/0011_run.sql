-- Run: the record that a version was scored from a bucket on. It is written last and makes the rows of
-- the run visible; rows of earlier runs from that bucket on are hidden.
CREATE TABLE IF NOT EXISTS stored_run (
  run_id BIGINT NOT NULL,
  version_id BIGINT NOT NULL,
  from_bucket BIGINT NOT NULL,
  read_from BIGINT NOT NULL,
  read_to BIGINT,
  rows_read BIGINT NOT NULL,
  context_rows BIGINT NOT NULL,
  context_expected BIGINT,
  calibration_readings BIGINT,
  lookback BIGINT NOT NULL,
  settled_bucket BIGINT,
  settled_time BIGINT,
  settled_context BIGINT,
  started BIGINT NOT NULL,
  committed BIGINT NOT NULL
);

COMMENT ON TABLE stored_run IS 'Finished runs of scoring; one row per run and version';
COMMENT ON COLUMN stored_run.run_id IS 'The run; a later one is larger';
COMMENT ON COLUMN stored_run.version_id IS 'The version';
COMMENT ON COLUMN stored_run.from_bucket IS 'First bucket that it wrote anew';
COMMENT ON COLUMN stored_run.read_from IS 'From which time on it read the channel';
COMMENT ON COLUMN stored_run.read_to
  IS 'Newest time that it read of the channel; NULL if there was no row';
COMMENT ON COLUMN stored_run.rows_read IS 'Rows of the channel that it read';
COMMENT ON COLUMN stored_run.context_rows
  IS 'Samples it read up to the end of the bucket before from_bucket';
COMMENT ON COLUMN stored_run.context_expected
  IS 'Samples there were when that bucket was written; NULL for the first bucket';
COMMENT ON COLUMN stored_run.calibration_readings
  IS 'Rows inside calibration, counted again; NULL if this run did not count';
COMMENT ON COLUMN stored_run.lookback
  IS 'How late a row may come, as this run took it, in the unit of time';
COMMENT ON COLUMN stored_run.settled_bucket
  IS 'Last bucket that no such row can change; -1 if there is none, NULL if no row was read';
COMMENT ON COLUMN stored_run.settled_time
  IS 'Time of its last vector: the next run scores what is newer; NULL if there is none';
COMMENT ON COLUMN stored_run.settled_context
  IS 'Its context_time: the next run reads from there; NULL if there is none';
COMMENT ON COLUMN stored_run.started IS 'When it began, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_run.committed IS 'When it was recorded, in microseconds since 1970 (UTC)';
