-- Alarm event: each change of an episode that somebody may want to be told, in order. A notifier remembers the largest seq
-- that it has seen.
CREATE OR REPLACE VIEW stored_alarm_event AS
SELECT
  watching.name AS monitor,
  told.seq AS seq,
  told.episode_id AS episode_id,
  told.what AS what,
  MAKE_TIMESTAMP(told.noticed_at) AS noticed_at,
  named.asset AS asset,
  named.channel AS channel,
  told.status AS status,
  told.is_proving AS is_proving
FROM stored_episode AS told
JOIN stored_monitor AS watching ON watching.monitor_id = told.monitor_id
JOIN stored_channel AS named ON named.channel_id = told.channel_id
WHERE told.what <> 'changed';

COMMENT ON VIEW stored_alarm_event IS 'Changes of episodes; one row per change, seq only grows within a monitor';
COMMENT ON COLUMN stored_alarm_event.monitor IS 'The monitor';
COMMENT ON COLUMN stored_alarm_event.seq IS 'Number of the change; a later one is larger';
COMMENT ON COLUMN stored_alarm_event.episode_id IS 'The episode';
COMMENT ON COLUMN stored_alarm_event.what IS 'opened, reopened, ended, merged, withdrawn, recalibrated or labelled';
COMMENT ON COLUMN stored_alarm_event.noticed_at IS 'When it was noticed (UTC)';
COMMENT ON COLUMN stored_alarm_event.asset IS 'The machine';
COMMENT ON COLUMN stored_alarm_event.channel IS 'The signal';
COMMENT ON COLUMN stored_alarm_event.status IS 'Of the episode from then on';
COMMENT ON COLUMN stored_alarm_event.is_proving IS '1 if it opened right after calibration, else 0';
