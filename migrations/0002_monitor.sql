-- Monitor: one source watched under one name; a database may hold several.
CREATE TABLE IF NOT EXISTS stored_monitor (
  monitor_id BIGINT NOT NULL,
  name VARCHAR NOT NULL,
  source VARCHAR NOT NULL,
  time_kind VARCHAR NOT NULL,
  created BIGINT NOT NULL
);

COMMENT ON TABLE stored_monitor IS 'One source watched under one name; one row per monitor';
COMMENT ON COLUMN stored_monitor.monitor_id IS 'Key of the monitor';
COMMENT ON COLUMN stored_monitor.name IS 'Its name, unique in these tables';
COMMENT ON COLUMN stored_monitor.source IS 'The relation it reads';
COMMENT ON COLUMN stored_monitor.time_kind
  IS 'How the source tells time: counter, or a kind of timestamp';
COMMENT ON COLUMN stored_monitor.created IS 'When it was made, in microseconds since 1970 (UTC)';
