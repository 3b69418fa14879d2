-- Episode records: what is known of each episode of a monitor now.
-- Reads:  stored_visible_episode
-- A row:  one episode.
-- Slots:  :monitor_id
SELECT
  episode_id,
  seq,
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
FROM stored_visible_episode
WHERE monitor_id = :monitor_id
