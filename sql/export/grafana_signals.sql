-- Grafana signals: what is known of each signal that is chosen now, the most urgent first.
-- Reads:  stored_fleet
-- A row:  one signal; remark is what people said of its episode, or that its indicator is far above hi_limit without one.
-- Slots:  :monitor   its name
--         :assets    the machines that are chosen
--         :channels  the signals that are chosen
SELECT
  asset,
  channel,
  status,
  CASE WHEN label IS NOT NULL THEN label WHEN is_far_above = 1 AND episode_id IS NULL THEN 'far above' END AS remark,
  judged_by,
  episode_id,
  hi,
  hi_limit,
  since_time,
  strength,
  out_of_range_in_window,
  limit_reason,
  data_time
FROM stored_fleet
WHERE monitor = :monitor AND asset IN (:assets) AND channel IN (:channels)
ORDER BY urgency DESC, CASE WHEN hi IS NULL THEN 1 ELSE 0 END, hi DESC, asset, channel
