-- Proof: when the state was compared with what it should be, and what came out.
CREATE TABLE IF NOT EXISTS stored_proof (
  monitor_id BIGINT NOT NULL,
  proved_at BIGINT NOT NULL,
  extent VARCHAR NOT NULL,
  channels BIGINT NOT NULL,
  versions BIGINT NOT NULL,
  buckets BIGINT NOT NULL,
  differences BIGINT NOT NULL
);

COMMENT ON TABLE stored_proof
  IS 'When the state of a monitor was checked, over what, and how many differences there were';
COMMENT ON COLUMN stored_proof.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_proof.proved_at IS 'When the check began, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_proof.extent
  IS 'state: all of it, with the source (gam check --state); checksums: what calibration froze';
COMMENT ON COLUMN stored_proof.channels IS 'Channels that were checked';
COMMENT ON COLUMN stored_proof.versions IS 'Versions that were checked';
COMMENT ON COLUMN stored_proof.buckets IS 'Visible buckets that were checked; 0 for checksums';
COMMENT ON COLUMN stored_proof.differences IS 'Differences that were found';
