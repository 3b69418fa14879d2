-- Declared lengths: how long calibration is, its intervals summed (alarms, section 3).
-- Reads:  calibration
-- A row:  one channel that has calibration; 0 where all that was declared are single instants.
SELECT channel_id, CAST(SUM(time_to - time_from) AS BIGINT) AS length
FROM calibration
GROUP BY channel_id
