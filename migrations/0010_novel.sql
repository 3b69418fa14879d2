-- Novel: the cells outside the support that each bucket visited. Rows are visible once their run is
-- recorded; read them through visible_novel.
CREATE TABLE IF NOT EXISTS stored_novel (
  version_id BIGINT NOT NULL,
  bucket_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  cell_key BIGINT NOT NULL,
  visits BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL
);

COMMENT ON TABLE stored_novel IS 'Novel cells of buckets, of all runs; read visible_novel instead';
COMMENT ON COLUMN stored_novel.version_id IS 'The version';
COMMENT ON COLUMN stored_novel.bucket_no IS 'The bucket';
COMMENT ON COLUMN stored_novel.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_novel.cell_key IS 'The cell: its bins on the m axes, as one integer';
COMMENT ON COLUMN stored_novel.visits IS 'Vectors of the bucket in it';
COMMENT ON COLUMN stored_novel.first_time IS 'Time of its first visit in the bucket';
COMMENT ON COLUMN stored_novel.last_time IS 'Time of its last visit in the bucket';
