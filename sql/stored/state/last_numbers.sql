-- Last numbers: the largest key in use of each kind; new ones go on from there.
-- Reads:  stored_monitor, stored_channel, stored_version, stored_calibration, stored_extent, stored_bounds,
--         stored_run
-- A row:  one kind of key; last_id is NULL where none is in use.
SELECT 'monitor' AS kind, MAX(monitor_id) AS last_id
FROM stored_monitor
UNION ALL
SELECT 'channel' AS kind, MAX(channel_id) AS last_id
FROM stored_channel
UNION ALL
SELECT 'version' AS kind, MAX(version_id) AS last_id
FROM stored_version
UNION ALL
SELECT 'calibration' AS kind, MAX(version_id) AS last_id
FROM stored_calibration
UNION ALL
SELECT 'extent' AS kind, MAX(version_id) AS last_id
FROM stored_extent
UNION ALL
SELECT 'support' AS kind, MAX(support_id) AS last_id
FROM stored_bounds
UNION ALL
SELECT 'run' AS kind, MAX(run_id) AS last_id
FROM stored_run
