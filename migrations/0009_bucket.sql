-- Bucket: scored vectors of a version, stride by stride; only full buckets are kept. Rows are visible
-- once their run is recorded; read them through visible_bucket.
CREATE TABLE IF NOT EXISTS stored_bucket (
  version_id BIGINT NOT NULL,
  bucket_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL,
  context_time BIGINT NOT NULL,
  samples BIGINT NOT NULL,
  novel BIGINT NOT NULL,
  out_of_range BIGINT NOT NULL,
  novel_in_window BIGINT
);

COMMENT ON TABLE stored_bucket
  IS 'Full buckets of scored vectors, of all runs; read visible_bucket instead';
COMMENT ON COLUMN stored_bucket.version_id IS 'The version';
COMMENT ON COLUMN stored_bucket.bucket_no
  IS 'Number of the bucket: (number of a scored vector - 1) div stride';
COMMENT ON COLUMN stored_bucket.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_bucket.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_bucket.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_bucket.context_time
  IS 'Time of the oldest sample of the next possible vector: where a restart reads from';
COMMENT ON COLUMN stored_bucket.samples
  IS 'Samples after the previous bucket up to the end of this one, missing ones included';
COMMENT ON COLUMN stored_bucket.novel IS 'Vectors in it whose cell is not in the support';
COMMENT ON COLUMN stored_bucket.out_of_range
  IS 'Vectors in it with a sample outside the range of calibration';
COMMENT ON COLUMN stored_bucket.novel_in_window
  IS 'Novel vectors in the window that ends with it; NULL until the window is full';
