-- Grafana alert: what the alert rule judges: 1 for a signal above its limit.
-- Reads:  stored_fleet
-- A row:  one signal that is judged.
-- Slots:  :monitor  its name
SELECT asset, channel, CAST(CASE WHEN status = 'high' THEN 1 ELSE 0 END AS DOUBLE) AS value
FROM stored_fleet
WHERE monitor = :monitor AND status IN ('high', 'ok')
ORDER BY asset, channel
