-- Unplaced: how many rows of the source a run could give to no channel or instant; the newest row says when the last
-- run was.
CREATE TABLE IF NOT EXISTS stored_unplaced (
  monitor_id BIGINT NOT NULL,
  started BIGINT NOT NULL,
  nameless BIGINT NOT NULL,
  undated BIGINT NOT NULL,
  strangers BIGINT NOT NULL,
  stranger_channels BIGINT NOT NULL,
  held BIGINT,
  invalid BIGINT
);

COMMENT ON TABLE stored_unplaced
  IS 'Rows that a run could give to no channel or instant; one row per run';
COMMENT ON COLUMN stored_unplaced.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_unplaced.started
  IS 'When the run began, in microseconds since 1970 (UTC); also in its rows of run';
COMMENT ON COLUMN stored_unplaced.nameless IS 'Rows of its range without asset or channel';
COMMENT ON COLUMN stored_unplaced.undated IS 'Rows of the source without a time';
COMMENT ON COLUMN stored_unplaced.strangers IS 'Rows of its range of channels that have no calibration';
COMMENT ON COLUMN stored_unplaced.stranger_channels IS 'How many such channels there were';
COMMENT ON COLUMN stored_unplaced.held
  IS 'Readings of its range that were held to valid_when; NULL where the source has no such condition';
COMMENT ON COLUMN stored_unplaced.invalid IS 'Those of them for which it does not hold, so that they are missing';
