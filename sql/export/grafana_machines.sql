-- Grafana machines: how many signals of each machine had an indicator above hi_limit at once, by stretches of time.
-- Reads:  stored_health
-- A row:  one stretch of one machine in which a bucket ended.
-- Slots:  :monitor  its name
--         :assets   the machines that are chosen
--         :stretch  the stretch of time in which a bucket ended
--         :shown    whether it ended in the time that is shown
SELECT ended AS time, asset AS metric, CAST(COUNT(DISTINCT high_channel) AS DOUBLE) AS value
FROM (
  SELECT asset, :stretch AS ended, CASE WHEN hi > hi_limit THEN channel END AS high_channel
  FROM stored_health
  WHERE monitor = :monitor AND asset IN (:assets) AND hi IS NOT NULL AND hi_limit IS NOT NULL AND :shown
) AS judged
GROUP BY ended, asset
ORDER BY ended, asset
