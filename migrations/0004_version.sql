-- Version: one calibration of one channel, with all that scoring against it needs. Written last of
-- all that a calibration writes; the version with the largest key is the active one.
CREATE TABLE IF NOT EXISTS stored_version (
  version_id BIGINT NOT NULL,
  channel_id BIGINT NOT NULL,
  support_id BIGINT NOT NULL,
  parent_id BIGINT,
  version_no BIGINT NOT NULL,
  status VARCHAR NOT NULL,
  reason VARCHAR NOT NULL,
  m BIGINT NOT NULL,
  tau BIGINT NOT NULL,
  bins BIGINT NOT NULL,
  window_length BIGINT NOT NULL,
  stride BIGINT NOT NULL,
  max_gap BIGINT,
  score_from BIGINT,
  target_floor DOUBLE NOT NULL,
  calibration_end BIGINT,
  first_scored BIGINT NOT NULL,
  run_up_from BIGINT NOT NULL,
  calibration_readings BIGINT NOT NULL,
  calibration_samples BIGINT NOT NULL,
  settings_hash VARCHAR NOT NULL,
  method_hash VARCHAR NOT NULL,
  created BIGINT NOT NULL
);

COMMENT ON TABLE stored_version
  IS 'Calibrations of channels; of each channel the one with the largest version_id is active';
COMMENT ON COLUMN stored_version.version_id IS 'Key of the version; a later one is larger';
COMMENT ON COLUMN stored_version.channel_id IS 'The channel';
COMMENT ON COLUMN stored_version.support_id IS 'What was learnt; versions of a pool share it';
COMMENT ON COLUMN stored_version.parent_id IS 'The version it replaced; NULL for the first';
COMMENT ON COLUMN stored_version.version_no IS '1, 2, ... within the channel';
COMMENT ON COLUMN stored_version.status IS 'active when it was made';
COMMENT ON COLUMN stored_version.reason IS 'Why it was made';
COMMENT ON COLUMN stored_version.m IS 'Embedding dimension';
COMMENT ON COLUMN stored_version.tau IS 'Delay, in samples';
COMMENT ON COLUMN stored_version.bins IS 'Bins per axis';
COMMENT ON COLUMN stored_version.window_length IS 'Scored vectors in the moving average';
COMMENT ON COLUMN stored_version.stride IS 'Scored vectors in a bucket; divides window_length';
COMMENT ON COLUMN stored_version.max_gap IS 'Longest step in time that is no pause; NULL for no limit';
COMMENT ON COLUMN stored_version.score_from
  IS 'First instant to score, where it was set; NULL for after calibration';
COMMENT ON COLUMN stored_version.target_floor IS 'Health indicator that a healthy machine may show';
COMMENT ON COLUMN stored_version.calibration_end
  IS 'Last instant of calibration; NULL without calibration';
COMMENT ON COLUMN stored_version.first_scored
  IS 'First instant that is scored; -2^62 is from the first sample on';
COMMENT ON COLUMN stored_version.run_up_from IS 'From where on a first run reads; -2^62 is everything';
COMMENT ON COLUMN stored_version.calibration_readings
  IS 'Rows of the source inside calibration when it was made';
COMMENT ON COLUMN stored_version.calibration_samples IS 'Samples inside calibration when it was made';
COMMENT ON COLUMN stored_version.settings_hash IS 'Hash of the settings it was made under';
COMMENT ON COLUMN stored_version.method_hash IS 'Hash of the SQL that learnt it';
COMMENT ON COLUMN stored_version.created IS 'When it was made, in microseconds since 1970 (UTC)';
