-- Alarm bands: in which part of its range an episode stands out, the most striking first.
-- Reads:  stored_alarm_band
-- A row:  one band.
-- Slots:  :monitor  its name
--         :episode_id, :version_id
--         :most     how many
SELECT
  place,
  value_from,
  value_to,
  novel,
  visits,
  calibration_novel,
  calibration_visits,
  excess
FROM stored_alarm_band
WHERE monitor = :monitor AND episode_id = :episode_id AND version_id = :version_id AND excess > CAST(0 AS DOUBLE)
ORDER BY excess DESC, band
LIMIT :most
