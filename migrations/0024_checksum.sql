-- Checksum: what calibration froze, a second time: integers as sums of sql/stored/mixed.sql, all else as it
-- is. Written with the version; one that is older gets what its tables hold when this table is made.
CREATE TABLE IF NOT EXISTS stored_checksum (
  version_id BIGINT NOT NULL,
  cells_sum BIGINT NOT NULL,
  intervals_sum BIGINT NOT NULL,
  figures_sum BIGINT NOT NULL,
  lo DOUBLE,
  hi DOUBLE,
  target_floor DOUBLE NOT NULL,
  settings_hash VARCHAR NOT NULL,
  method_hash VARCHAR NOT NULL
);

COMMENT ON TABLE stored_checksum
  IS 'What calibration froze, a second time, so that damage is noticed; one row per version';
COMMENT ON COLUMN stored_checksum.version_id IS 'The version';
COMMENT ON COLUMN stored_checksum.cells_sum IS 'Checksum of the cells of its support and their visits';
COMMENT ON COLUMN stored_checksum.intervals_sum IS 'Checksum of the intervals it learnt from';
COMMENT ON COLUMN stored_checksum.figures_sum
  IS 'Checksum of the integers of the version and of the certificate';
COMMENT ON COLUMN stored_checksum.lo IS 'Smallest calibration value; NULL without calibration';
COMMENT ON COLUMN stored_checksum.hi IS 'Largest calibration value; NULL without calibration';
COMMENT ON COLUMN stored_checksum.target_floor IS 'Health indicator that a healthy machine may show';
COMMENT ON COLUMN stored_checksum.settings_hash IS 'Hash of the settings it was made under';
COMMENT ON COLUMN stored_checksum.method_hash IS 'Hash of the SQL that learnt it';
