-- Judgement: a full window of scored vectors, with what it says. Rows are visible once their run is recorded; read them
-- through visible_judgement.
CREATE TABLE IF NOT EXISTS stored_judgement (
  version_id BIGINT NOT NULL,
  bucket_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  judgement_no BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL,
  novel BIGINT NOT NULL,
  root BIGINT NOT NULL,
  reference BIGINT NOT NULL,
  height BIGINT NOT NULL,
  evidence BIGINT NOT NULL,
  is_open BIGINT NOT NULL,
  last_zero BIGINT
);

COMMENT ON TABLE stored_judgement
  IS 'Judgements of channels that have a limit, of all runs; read visible_judgement instead';
COMMENT ON COLUMN stored_judgement.version_id IS 'The version';
COMMENT ON COLUMN stored_judgement.bucket_no IS 'The bucket that closes it: its last one';
COMMENT ON COLUMN stored_judgement.run_id IS 'The run that wrote that bucket';
COMMENT ON COLUMN stored_judgement.judgement_no IS 'Number of the judgement, from 0';
COMMENT ON COLUMN stored_judgement.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_judgement.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_judgement.novel IS 'Novel vectors in its window';
COMMENT ON COLUMN stored_judgement.root IS 'Square root of that, in thousandths';
COMMENT ON COLUMN stored_judgement.reference IS 'Root above which it is raised';
COMMENT ON COLUMN stored_judgement.height IS 'Evidence that opens an episode';
COMMENT ON COLUMN stored_judgement.evidence IS 'How far roots stood above the reference of late, summed';
COMMENT ON COLUMN stored_judgement.is_open IS '1 if it belongs to an episode, else 0';
COMMENT ON COLUMN stored_judgement.last_zero
  IS 'The latest judgement without evidence, up to this one; NULL if there was none';
