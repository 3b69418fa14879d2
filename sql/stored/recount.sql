-- Recount: the rows that lie in the intervals of calibration. Where it is no longer the number that the
-- version was made from, rows of calibration came or went since.
-- Reads:  identified, calibration
-- A row:  one channel that has such a row.
SELECT
  reading.channel_id AS channel_id,
  CAST(COUNT(*) AS BIGINT) AS calibration_readings
FROM identified AS reading
JOIN calibration AS piece ON piece.channel_id = reading.channel_id
WHERE reading.time BETWEEN piece.time_from AND piece.time_to
GROUP BY reading.channel_id
