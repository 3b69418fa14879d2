-- Episode: the history of what was raised: a row for each time that an episode became known, or other than it was. The
-- newest row of an id counts.
CREATE TABLE IF NOT EXISTS stored_episode (
  monitor_id BIGINT NOT NULL,
  episode_id BIGINT NOT NULL,
  seq BIGINT NOT NULL,
  noticed_at BIGINT NOT NULL,
  what VARCHAR NOT NULL,
  status VARCHAR NOT NULL,
  merged_into BIGINT,
  channel_id BIGINT NOT NULL,
  version_id BIGINT NOT NULL,
  onset BIGINT NOT NULL,
  first_judgement BIGINT NOT NULL,
  last_judgement BIGINT NOT NULL,
  onset_time BIGINT NOT NULL,
  first_time BIGINT NOT NULL,
  last_time BIGINT NOT NULL,
  evidence BIGINT NOT NULL,
  height BIGINT NOT NULL,
  is_proving BIGINT NOT NULL
);

COMMENT ON TABLE stored_episode IS 'History of episodes; one row per change, of which the newest of an episode counts';
COMMENT ON COLUMN stored_episode.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_episode.episode_id IS 'Number of the episode within the monitor, given once';
COMMENT ON COLUMN stored_episode.seq IS 'Number of the change within the monitor; it only grows';
COMMENT ON COLUMN stored_episode.noticed_at IS 'When it was noticed, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_episode.what
  IS 'opened, reopened, ended, merged, withdrawn, recalibrated or labelled; changed where only its extent did';
COMMENT ON COLUMN stored_episode.status IS 'open, ended, merged, withdrawn or recalibrated';
COMMENT ON COLUMN stored_episode.merged_into IS 'The episode that it is a part of; NULL unless merged';
COMMENT ON COLUMN stored_episode.channel_id IS 'The channel';
COMMENT ON COLUMN stored_episode.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_episode.onset IS 'The judgement in which its evidence left 0';
COMMENT ON COLUMN stored_episode.first_judgement IS 'The judgement that opened it';
COMMENT ON COLUMN stored_episode.last_judgement IS 'Its last open judgement';
COMMENT ON COLUMN stored_episode.onset_time IS 'When the judgement of its onset begins';
COMMENT ON COLUMN stored_episode.first_time IS 'When the judgement begins that opened it';
COMMENT ON COLUMN stored_episode.last_time IS 'When its last open judgement ends';
COMMENT ON COLUMN stored_episode.evidence IS 'The highest evidence in it';
COMMENT ON COLUMN stored_episode.height IS 'Evidence that opened it';
COMMENT ON COLUMN stored_episode.is_proving
  IS '1 if it opened within as many judgements as calibration has blocks, else 0';
