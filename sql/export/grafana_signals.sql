-- Grafana signals: what is known of each signal that is chosen now, the most urgent first.
-- Reads:  stored_fleet
-- A row:  one signal.
-- Slots:  :monitor   its name
--         :assets    the machines that are chosen
--         :channels  the signals that are chosen
SELECT asset, channel, status, judged_by, episode_id, hi, hi_limit, since_time, out_of_range_in_window, limit_reason, data_time
FROM stored_fleet
WHERE monitor = :monitor AND asset IN (:assets) AND channel IN (:channels)
ORDER BY urgency DESC, CASE WHEN hi IS NULL THEN 1 ELSE 0 END, hi DESC, asset, channel
