-- Block: the two integers of the certificate for each block of calibration.
CREATE TABLE IF NOT EXISTS stored_block (
  support_id BIGINT NOT NULL,
  block BIGINT NOT NULL,
  channel_id BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL,
  vectors BIGINT NOT NULL,
  novel BIGINT NOT NULL
);

COMMENT ON TABLE stored_block
  IS 'Blocks of calibration, each left out and scored against the others; one row per block';
COMMENT ON COLUMN stored_block.support_id IS 'The support';
COMMENT ON COLUMN stored_block.block IS 'Number of the block within its channel, from 0';
COMMENT ON COLUMN stored_block.channel_id IS 'The channel whose vectors it holds';
COMMENT ON COLUMN stored_block.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_block.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_block.vectors IS 'Vectors in it';
COMMENT ON COLUMN stored_block.novel IS 'Those whose cell no other block visited';
