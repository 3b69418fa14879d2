-- Episode history: all that was ever noted of a monitor's episodes.
-- Reads:  stored_episode
-- A row:  one change, in order.
-- Slots:  :monitor_id
SELECT
  seq,
  episode_id,
  what,
  status,
  merged_into,
  channel_id,
  version_id,
  onset,
  first_judgement,
  last_judgement,
  onset_time,
  first_time,
  last_time,
  evidence,
  height,
  is_proving
FROM stored_episode
WHERE monitor_id = :monitor_id
ORDER BY seq, episode_id
