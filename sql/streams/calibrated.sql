-- Calibrated, one channel: its range over calibration; as calibration/calibrated.sql.
-- For DuckDB, which leaves out most rows of other channels where they lie apart: no name is joined and nothing
-- grouped. Proof: as many samples lie up to the end of calibration, and from read_from on, as streams/series.sql
-- was asked for.
-- Reads:  readings
-- A row:  the channel, if it has a calibration sample.
-- Slots:  :asset, :channel
--         :time_from, :time_to  the instants of calibration
--         :value      the reading, where it is a number; or as it is, where no sample is missing
--         :read_from  context_samples are those from here on
SELECT
  MIN(:value) AS lowest,
  MAX(:value) AS highest,
  CAST(COUNT(*) AS BIGINT) AS calibration_samples,
  CAST(SUM(CASE WHEN reading.time >= :read_from THEN 1 ELSE 0 END) AS BIGINT) AS context_samples
FROM readings AS reading
WHERE reading.asset = :asset
  AND reading.channel = :channel
  AND reading.time BETWEEN :time_from AND :time_to
HAVING COUNT(*) > 0
