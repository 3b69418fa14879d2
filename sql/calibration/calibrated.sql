-- Calibrated: the range of each channel's calibration samples, missing ones counted apart.
-- Reads:  samples, calibration
-- A row:  one channel that has at least one calibration sample.
SELECT
  sample.channel_id AS channel_id,
  MIN(sample.value) AS lowest,
  MAX(sample.value) AS highest,
  COUNT(*) AS calibration_samples
FROM samples AS sample
JOIN calibration AS piece ON piece.channel_id = sample.channel_id
WHERE sample.time BETWEEN piece.time_from AND piece.time_to
GROUP BY sample.channel_id
