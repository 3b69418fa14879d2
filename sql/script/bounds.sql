-- Bounds: the range of each channel in that period.
-- Reads:  channels, calibrated
-- Slots:  :dropped      what is told of samples outside the range
--         :carried      columns that travel along
--         :settings_no  the number of the set
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CASE WHEN seen.hit = 1 THEN seen.lowest END AS calibrated_lo,
  CASE WHEN seen.hit = 1 THEN seen.highest END AS calibrated_hi,
  CASE WHEN seen.hit = 1 THEN seen.calibration_samples ELSE 0 END AS calibration_samples,
  :dropped
FROM channels AS named
LEFT JOIN (
  SELECT asset, channel, lowest, highest, calibration_samples, :carried, 1 AS hit
  FROM calibrated
) AS seen ON seen.asset = named.asset AND seen.channel = named.channel
WHERE named.settings_no = :settings_no
