-- Left out: the channels of which the newest run left rows out, and why.
CREATE TABLE IF NOT EXISTS stored_left_out (
  monitor_id BIGINT NOT NULL,
  started BIGINT NOT NULL,
  kind VARCHAR NOT NULL,
  asset VARCHAR,
  channel VARCHAR,
  readings BIGINT NOT NULL,
  latest BIGINT NOT NULL
);

COMMENT ON TABLE stored_left_out
  IS 'Channels of which a run left rows out, one row each; those of the newest run count';
COMMENT ON COLUMN stored_left_out.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_left_out.started
  IS 'When the run began, in microseconds since 1970 (UTC); also in its row of unplaced';
COMMENT ON COLUMN stored_left_out.kind
  IS 'ahead: rows later than now; unknown: rows of a channel that has no calibration; jump: a counter jumped';
COMMENT ON COLUMN stored_left_out.asset IS 'The machine; NULL where its rows name none';
COMMENT ON COLUMN stored_left_out.channel IS 'The signal; NULL where its rows name none';
COMMENT ON COLUMN stored_left_out.readings IS 'Rows that were left out; of a jump, how far it goes';
COMMENT ON COLUMN stored_left_out.latest
  IS 'The latest of their times, in microseconds since 1970 (UTC), or as the counter of the source';
