-- Alarm rows: the episodes of a monitor, for people.
-- Reads:  stored_alarm
-- A row:  one episode, the newest first.
-- Slots:  :monitor  its name
SELECT
  episode_id,
  asset,
  channel,
  status,
  told_as,
  needs_attention,
  label,
  label_until,
  note,
  since_tick,
  first_tick,
  last_tick,
  onset,
  first_judgement,
  last_judgement,
  evidence,
  height,
  basis,
  asked,
  stated_rate,
  signals_open,
  group_id,
  signals_together,
  merged_into,
  seq,
  version_id,
  channel_id
FROM stored_alarm
WHERE monitor = :monitor
ORDER BY episode_id DESC
