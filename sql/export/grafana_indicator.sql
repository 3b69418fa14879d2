-- Grafana indicator: the indicator of each signal that is chosen, and its limit.
-- Reads:  stored_health
-- A row:  one full bucket of a signal, or its limit there.
-- Slots:  :monitor   its name
--         :assets    the machines that are chosen
--         :channels  the signals that are chosen
--         :shown     whether a bucket ended in the time that is shown
SELECT last_time AS time, metric, value
FROM (
  SELECT last_time, asset || ' ' || channel AS metric, hi AS value
  FROM stored_health
  WHERE monitor = :monitor AND asset IN (:assets) AND channel IN (:channels) AND hi IS NOT NULL AND :shown
  UNION ALL
  SELECT last_time, asset || ' ' || channel || ' limit' AS metric, hi_limit AS value
  FROM stored_health
  WHERE monitor = :monitor AND asset IN (:assets) AND channel IN (:channels) AND hi IS NOT NULL
    AND hi_limit IS NOT NULL AND :shown
) AS drawn
ORDER BY last_time, metric
