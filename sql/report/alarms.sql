-- Alarms: the episodes of one monitor as they are now, but for those that are a part of another.
-- Reads:  stored_alarm
-- A row:  one episode; times are integers.
-- Slots:  :monitor  its name
SELECT episode_id, asset, channel, status, is_proving, label, note, since_tick, first_tick, last_tick, evidence, height
FROM stored_alarm
WHERE monitor = :monitor AND status <> 'merged'
ORDER BY CASE WHEN status = 'open' THEN 0 ELSE 1 END, since_tick DESC, episode_id
