-- Bounds: the range of a support, and the certificate of its calibration.
CREATE TABLE IF NOT EXISTS stored_bounds (
  support_id BIGINT NOT NULL,
  lo DOUBLE,
  hi DOUBLE,
  calibration_vectors BIGINT NOT NULL,
  cells BIGINT NOT NULL,
  seen_once BIGINT NOT NULL,
  blocks BIGINT NOT NULL,
  verdict VARCHAR NOT NULL,
  floor DOUBLE,
  floor_sd DOUBLE,
  floor_max DOUBLE,
  finest_bins BIGINT,
  vectors_needed BIGINT
);

COMMENT ON TABLE stored_bounds IS 'Range and certificate of a support; one row per support';
COMMENT ON COLUMN stored_bounds.support_id IS 'Key of the support';
COMMENT ON COLUMN stored_bounds.lo IS 'Smallest calibration value; NULL without calibration';
COMMENT ON COLUMN stored_bounds.hi IS 'Largest calibration value; NULL without calibration';
COMMENT ON COLUMN stored_bounds.calibration_vectors IS 'Vectors that were learnt';
COMMENT ON COLUMN stored_bounds.cells IS 'Cells that healthy operation visited';
COMMENT ON COLUMN stored_bounds.seen_once IS 'Cells visited by one vector only';
COMMENT ON COLUMN stored_bounds.blocks IS 'Blocks of one window each that calibration was cut into';
COMMENT ON COLUMN stored_bounds.verdict IS 'ready, too_fine, needs_data, constant or no_data';
COMMENT ON COLUMN stored_bounds.floor
  IS 'Expected health indicator of healthy operation; NULL if there are too few blocks';
COMMENT ON COLUMN stored_bounds.floor_sd
  IS 'Standard deviation of the blocks around the floor; NULL if there are too few blocks';
COMMENT ON COLUMN stored_bounds.floor_max
  IS 'Highest block of calibration; NULL if there are too few blocks';
COMMENT ON COLUMN stored_bounds.finest_bins IS 'Finest bins that meet the target; NULL if none do';
COMMENT ON COLUMN stored_bounds.vectors_needed
  IS 'Estimate of the further calibration vectors needed; 0 if none, NULL if unknown';
