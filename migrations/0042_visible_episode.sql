-- Visible episode: what is known of every episode now: its newest row.
CREATE OR REPLACE VIEW stored_visible_episode AS
SELECT
  kept.monitor_id AS monitor_id,
  kept.episode_id AS episode_id,
  kept.seq AS seq,
  kept.noticed_at AS noticed_at,
  kept.what AS what,
  kept.status AS status,
  kept.merged_into AS merged_into,
  kept.channel_id AS channel_id,
  kept.version_id AS version_id,
  kept.onset AS onset,
  kept.first_judgement AS first_judgement,
  kept.last_judgement AS last_judgement,
  kept.onset_time AS onset_time,
  kept.first_time AS first_time,
  kept.last_time AS last_time,
  kept.evidence AS evidence,
  kept.height AS height,
  kept.is_proving AS is_proving
FROM stored_episode AS kept
JOIN (
  SELECT monitor_id, episode_id, MAX(seq) AS newest_seq
  FROM stored_episode
  GROUP BY monitor_id, episode_id
) AS newest ON newest.monitor_id = kept.monitor_id AND newest.newest_seq = kept.seq;

COMMENT ON VIEW stored_visible_episode IS 'Episodes as they are now; one row per episode';
COMMENT ON COLUMN stored_visible_episode.monitor_id IS 'The monitor';
COMMENT ON COLUMN stored_visible_episode.episode_id IS 'Number of the episode within the monitor, given once';
COMMENT ON COLUMN stored_visible_episode.seq IS 'Number of the change within the monitor; it only grows';
COMMENT ON COLUMN stored_visible_episode.noticed_at IS 'When it was noticed, in microseconds since 1970 (UTC)';
COMMENT ON COLUMN stored_visible_episode.what
  IS 'opened, reopened, ended, merged, withdrawn, recalibrated or labelled; changed where only its extent did';
COMMENT ON COLUMN stored_visible_episode.status IS 'open, ended, merged, withdrawn or recalibrated';
COMMENT ON COLUMN stored_visible_episode.merged_into IS 'The episode that it is a part of; NULL unless merged';
COMMENT ON COLUMN stored_visible_episode.channel_id IS 'The channel';
COMMENT ON COLUMN stored_visible_episode.version_id IS 'The version whose judgements it is made of';
COMMENT ON COLUMN stored_visible_episode.onset IS 'The judgement in which its evidence left 0';
COMMENT ON COLUMN stored_visible_episode.first_judgement IS 'The judgement that opened it';
COMMENT ON COLUMN stored_visible_episode.last_judgement IS 'Its last open judgement';
COMMENT ON COLUMN stored_visible_episode.onset_time IS 'When the judgement of its onset begins';
COMMENT ON COLUMN stored_visible_episode.first_time IS 'When the judgement begins that opened it';
COMMENT ON COLUMN stored_visible_episode.last_time IS 'When its last open judgement ends';
COMMENT ON COLUMN stored_visible_episode.evidence IS 'The highest evidence in it';
COMMENT ON COLUMN stored_visible_episode.height IS 'Evidence that opened it';
COMMENT ON COLUMN stored_visible_episode.is_proving
  IS '1 if it opened within as many judgements as calibration has blocks, else 0';
