-- Monitor: one source watched under one name; a database may hold several.
CREATE TABLE IF NOT EXISTS stored_monitor (
  monitor_id BIGINT NOT NULL,
  name VARCHAR NOT NULL,
  source VARCHAR NOT NULL,
  layout VARCHAR NOT NULL,
  asset_column VARCHAR,
  channel_column VARCHAR,
  time_column VARCHAR NOT NULL,
  value_column VARCHAR,
  condition VARCHAR,
  time_kind VARCHAR NOT NULL,
  created BIGINT NOT NULL
);

COMMENT ON TABLE stored_monitor IS 'One source watched under one name; one row per monitor';
COMMENT ON COLUMN stored_monitor.monitor_id IS 'Key of the monitor';
COMMENT ON COLUMN stored_monitor.name IS 'Its name, unique in these tables';
COMMENT ON COLUMN stored_monitor.source IS 'The relation it reads';
COMMENT ON COLUMN stored_monitor.layout
  IS 'long (a row per reading) or wide (a column per channel)';
COMMENT ON COLUMN stored_monitor.asset_column
  IS 'Column that names the machine; NULL if there is only one';
COMMENT ON COLUMN stored_monitor.channel_column
  IS 'Column that names the signal; NULL if there is only one, or a column for each';
COMMENT ON COLUMN stored_monitor.time_column IS 'Column with the time of a reading';
COMMENT ON COLUMN stored_monitor.value_column IS 'Column with the reading; NULL if there is one per channel';
COMMENT ON COLUMN stored_monitor.condition IS 'Which rows are taken, in SQL; NULL for all';
COMMENT ON COLUMN stored_monitor.time_kind
  IS 'How the source tells time: counter, or a kind of timestamp';
COMMENT ON COLUMN stored_monitor.created IS 'When it was made, in microseconds since 1970 (UTC)';
