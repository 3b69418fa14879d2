-- Band: where calibration was, by the newest coordinate, and how much of that stayed near one time (sql/alarms/bands.sql);
-- beside it the novel vectors of an episode say where the signal went.
CREATE TABLE IF NOT EXISTS stored_band (
  version_id BIGINT NOT NULL,
  g BIGINT NOT NULL,
  band BIGINT NOT NULL,
  visits BIGINT NOT NULL,
  novel_buffered BIGINT NOT NULL
);

COMMENT ON TABLE stored_band
  IS 'Where the calibration of a version was: a band holds bins of the newest sample; one row per band and width';
COMMENT ON COLUMN stored_band.version_id IS 'The version';
COMMENT ON COLUMN stored_band.g IS 'Blocks up to so far away do not vouch for a cell';
COMMENT ON COLUMN stored_band.band
  IS '-1 below the range of calibration, 0, 1, ... in it from low to high, 20 (or bins, if they are fewer) above it';
COMMENT ON COLUMN stored_band.visits IS 'Vectors of calibration in it';
COMMENT ON COLUMN stored_band.novel_buffered IS 'Those whose cell no block farther away visited';
