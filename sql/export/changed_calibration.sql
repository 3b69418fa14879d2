-- Changed calibration: channels whose calibration holds another number of rows than when it was learnt: rows
-- came late, or went. What was learnt is frozen; a full refresh learns anew.
-- Reads:  stored_channel, recount
-- A row:  one such channel.
SELECT
  channel_row.asset AS asset,
  channel_row.channel AS channel,
  channel_row.calibration_readings AS calibration_readings,
  CASE WHEN counted.hit = 1 THEN counted.calibration_readings ELSE 0 END AS calibration_readings_now
FROM stored_channel AS channel_row
LEFT JOIN (
  SELECT channel_id, calibration_readings, 1 AS hit
  FROM recount
) AS counted ON counted.channel_id = channel_row.channel_id
WHERE channel_row.calibration_readings
  <> CASE WHEN counted.hit = 1 THEN counted.calibration_readings ELSE 0 END
