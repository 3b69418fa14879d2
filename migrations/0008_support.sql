-- Support: the cells that healthy operation visited.
CREATE TABLE IF NOT EXISTS stored_support (
  support_id BIGINT NOT NULL,
  cell_key BIGINT NOT NULL,
  visits BIGINT NOT NULL,
  first_block BIGINT NOT NULL,
  last_block BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL
);

COMMENT ON TABLE stored_support IS 'Cells that calibration visited; one row per cell of a support';
COMMENT ON COLUMN stored_support.support_id IS 'The support';
COMMENT ON COLUMN stored_support.cell_key IS 'The cell: its bins on the m axes, as one integer';
COMMENT ON COLUMN stored_support.visits IS 'Calibration vectors in it';
COMMENT ON COLUMN stored_support.first_block
  IS 'First block that visited it, numbered within the support';
COMMENT ON COLUMN stored_support.last_block
  IS 'Last block that visited it, numbered within the support';
COMMENT ON COLUMN stored_support.first_time IS 'Time of its first visit';
COMMENT ON COLUMN stored_support.last_time IS 'Time of its last visit';
