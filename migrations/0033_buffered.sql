-- Buffered: of each block of calibration the vectors in cells that only blocks near it visited; what limits are
-- made of (sql/alarms/buffered.sql).
CREATE TABLE IF NOT EXISTS stored_buffered (
  version_id BIGINT NOT NULL,
  block BIGINT NOT NULL,
  g BIGINT NOT NULL,
  vectors BIGINT NOT NULL,
  novel_buffered BIGINT NOT NULL
);

COMMENT ON TABLE stored_buffered
  IS 'What calibration says of judgements: the blocks of a version, each for three widths; one row per block and width';
COMMENT ON COLUMN stored_buffered.version_id IS 'The version';
COMMENT ON COLUMN stored_buffered.block IS 'Number of the block within its channel, from 0';
COMMENT ON COLUMN stored_buffered.g IS 'Blocks up to so far away do not vouch for a cell';
COMMENT ON COLUMN stored_buffered.vectors IS 'Vectors in the block';
COMMENT ON COLUMN stored_buffered.novel_buffered IS 'Those whose cell no block farther away visited';
