-- Channel: one signal of one machine.
CREATE TABLE IF NOT EXISTS stored_channel (
  channel_id BIGINT NOT NULL,
  monitor_id BIGINT NOT NULL,
  asset VARCHAR NOT NULL,
  channel VARCHAR NOT NULL
);

COMMENT ON TABLE stored_channel
  IS 'One signal of one machine, as a monitor found it; one row per channel';
COMMENT ON COLUMN stored_channel.channel_id IS 'Key of the channel';
COMMENT ON COLUMN stored_channel.monitor_id IS 'The monitor that watches it';
COMMENT ON COLUMN stored_channel.asset IS 'The machine';
COMMENT ON COLUMN stored_channel.channel IS 'The signal';
