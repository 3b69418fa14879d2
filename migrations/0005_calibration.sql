-- Calibration: the intervals a version learnt from, as they were resolved then.
CREATE TABLE IF NOT EXISTS stored_calibration (
  version_id BIGINT NOT NULL,
  time_from BIGINT NOT NULL,
  time_to BIGINT NOT NULL
);

COMMENT ON TABLE stored_calibration
  IS 'Closed intervals of time that a version learnt from, frozen; one row per interval';
COMMENT ON COLUMN stored_calibration.version_id IS 'The version';
COMMENT ON COLUMN stored_calibration.time_from IS 'First instant of the interval';
COMMENT ON COLUMN stored_calibration.time_to IS 'Last instant of the interval, itself included';
