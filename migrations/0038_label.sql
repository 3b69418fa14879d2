-- Label: what people said of an episode, or of a machine in an interval of time.
CREATE TABLE IF NOT EXISTS stored_label (
  monitor_id BIGINT NOT NULL,
  label_id BIGINT NOT NULL,
  episode_id BIGINT,
  asset VARCHAR NOT NULL,
  time_from BIGINT NOT NULL,
  time_to BIGINT NOT NULL,
  kind VARCHAR NOT NULL,
  note VARCHAR,
  until BIGINT,
  created BIGINT NOT NULL
);

COMMENT ON TABLE stored_label IS 'What people said of episodes and machines; one row per label';
COMMENT ON COLUMN stored_label.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_label.label_id IS 'Number of the label within the monitor; the newest of an episode counts';
COMMENT ON COLUMN stored_label.episode_id IS 'The episode; NULL where a machine was labelled';
COMMENT ON COLUMN stored_label.asset IS 'The machine';
COMMENT ON COLUMN stored_label.time_from IS 'First instant that it is about';
COMMENT ON COLUMN stored_label.time_to IS 'Last instant that it is about';
COMMENT ON COLUMN stored_label.kind IS 'true_fault, false_alarm, maintenance, new_program, acknowledged or snoozed';
COMMENT ON COLUMN stored_label.note IS 'What was said beside it; NULL if nothing';
COMMENT ON COLUMN stored_label.until IS 'When it ends, in microseconds since 1970 (UTC); NULL if it does not';
COMMENT ON COLUMN stored_label.created IS 'When it was made, in microseconds since 1970 (UTC)';
