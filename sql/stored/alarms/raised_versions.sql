-- Raised versions: those of a monitor that have episodes.
-- Reads:  stored_visible_episode
-- A row:  one version.
-- Slots:  :monitor_id
SELECT DISTINCT version_id
FROM stored_visible_episode
WHERE monitor_id = :monitor_id AND status IN ('open', 'ended')
