-- Calibrated: the range of each channel in its healthy period.
-- Reads:  history
SELECT
  asset,
  channel,
  MIN(value) AS lowest,
  MAX(value) AS highest,
  CAST(COUNT(*) AS BIGINT) AS calibration_samples
FROM history
WHERE calibrating = 1
GROUP BY asset, channel
