-- Doubled: keys that two writers gave at the same time. Where there are transactions, one of them fails.
-- Reads:  stored_monitor, stored_channel, stored_version
-- A row:  one key that is there more than once.
SELECT 'monitor' AS kind, monitor_id AS doubled_id
FROM stored_monitor
GROUP BY monitor_id
HAVING COUNT(*) > 1
UNION ALL
SELECT 'channel' AS kind, channel_id AS doubled_id
FROM stored_channel
GROUP BY channel_id
HAVING COUNT(*) > 1
UNION ALL
SELECT 'version' AS kind, version_id AS doubled_id
FROM stored_version
GROUP BY version_id
HAVING COUNT(*) > 1
