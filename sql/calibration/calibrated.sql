-- Calibrated: the range of each channel's calibration samples, missing ones counted apart.
-- Reads:  samples, calibration
-- A row:  one channel that has at least one calibration sample.
SELECT
  sampled.channel_id AS channel_id,
  MIN(sampled.value) AS lowest,
  MAX(sampled.value) AS highest,
  CAST(COUNT(*) AS BIGINT) AS calibration_samples
FROM samples AS sampled
JOIN calibration AS piece ON piece.channel_id = sampled.channel_id
WHERE sampled.time BETWEEN piece.time_from AND piece.time_to
GROUP BY sampled.channel_id
