-- Taught readings: the samples up to the end of calibration; kept, since several steps read them and none other.
-- Reads:  samples, limits
-- A row:  one sample.
SELECT
  sampled.channel_id AS channel_id,
  sampled.time AS time,
  sampled.value AS value,
  sampled.conflict AS conflict
FROM samples AS sampled
JOIN limits AS edge ON edge.channel_id = sampled.channel_id
WHERE sampled.time <= edge.calibration_end
