-- Grafana alert: what the alert rule judges: 1 for a signal above its limit (by its episode, or by its indicator where it
-- has no limit of judgements), unless somebody put its episode aside.
-- Reads:  stored_fleet
-- A row:  one signal that is judged.
-- Slots:  :monitor  its name
SELECT asset, channel, CAST(CASE WHEN is_above = 1 AND needs_attention = 1 THEN 1 ELSE 0 END AS DOUBLE) AS value
FROM stored_fleet
WHERE monitor = :monitor AND is_above IS NOT NULL
ORDER BY asset, channel
