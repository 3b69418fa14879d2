-- Extent: how much calibration a version had, and whether it is a fair sample of what follows.
CREATE TABLE IF NOT EXISTS stored_extent (
  version_id BIGINT NOT NULL,
  vectors BIGINT NOT NULL,
  calibration_length BIGINT NOT NULL,
  order_ratio BIGINT
);

COMMENT ON TABLE stored_extent
  IS 'How long the calibration of a version is, and in what order its cells came; one row per version';
COMMENT ON COLUMN stored_extent.version_id IS 'The version';
COMMENT ON COLUMN stored_extent.vectors IS 'Calibration vectors of its own channel';
COMMENT ON COLUMN stored_extent.calibration_length
  IS 'Its intervals summed, in the unit of time; from first to last sample where that is 0';
COMMENT ON COLUMN stored_extent.order_ratio
  IS 'Vectors in cells visited near one time only, by those of random order, in thousandths';
