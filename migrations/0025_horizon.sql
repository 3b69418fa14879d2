-- Horizon: how far back buckets and novel cells are kept of a version; what is older was pruned. Without it,
-- rows that were lost could not be told from rows that were pruned.
CREATE TABLE IF NOT EXISTS stored_horizon (
  version_id BIGINT NOT NULL,
  first_bucket BIGINT NOT NULL,
  first_novel BIGINT NOT NULL
);

COMMENT ON TABLE stored_horizon
  IS 'From where on buckets and novel cells are kept; of each version the largest counts, without a row all';
COMMENT ON COLUMN stored_horizon.version_id IS 'The version';
COMMENT ON COLUMN stored_horizon.first_bucket IS 'First bucket that pruning left';
COMMENT ON COLUMN stored_horizon.first_novel IS 'First bucket of which it left the novel cells';
