-- Calibrated, one channel: its range over calibration, where it has no missing sample; see calibration/calibrated.sql.
-- Reads:  readings
-- A row:  the channel, if it has a calibration sample.
-- Slots:  :asset, :channel
--         :time_from, :time_to  the instants of calibration
--         :read_from  context_samples are those from here on
SELECT
  MIN(reading.reading) AS lowest,
  MAX(reading.reading) AS highest,
  CAST(COUNT(*) AS BIGINT) AS calibration_samples,
  CAST(SUM(CASE WHEN reading.time >= :read_from THEN 1 ELSE 0 END) AS BIGINT) AS context_samples
FROM readings AS reading
WHERE reading.asset = :asset
  AND reading.channel = :channel
  AND reading.time BETWEEN :time_from AND :time_to
HAVING COUNT(*) > 0
