-- Band visit: where the signal was in the first five judgements of an episode, by the newest coordinate. A run reads the
-- source again for it. Rows belong to the judgement that a run wrote: of one that was written again they count no more.
CREATE TABLE IF NOT EXISTS stored_band_visit (
  version_id BIGINT NOT NULL,
  judgement_no BIGINT NOT NULL,
  run_id BIGINT NOT NULL,
  band BIGINT NOT NULL,
  visits BIGINT NOT NULL,
  novel BIGINT NOT NULL
);

COMMENT ON TABLE stored_band_visit
  IS 'Where the signal was in the first judgements of an episode; one row per judgement and band, a second one says the same';
COMMENT ON COLUMN stored_band_visit.version_id IS 'The version';
COMMENT ON COLUMN stored_band_visit.judgement_no IS 'Number of the judgement';
COMMENT ON COLUMN stored_band_visit.run_id IS 'The run that wrote the judgement';
COMMENT ON COLUMN stored_band_visit.band
  IS '-1 below the range of calibration, 0, 1, ... in it from low to high, 20 (or bins, if they are fewer) above it';
COMMENT ON COLUMN stored_band_visit.visits IS 'Scored vectors in it; 0 where the source no longer holds what was scored';
COMMENT ON COLUMN stored_band_visit.novel IS 'The novel ones of them';
