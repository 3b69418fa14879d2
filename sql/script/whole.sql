-- Whole: the range of all samples of calibration, before any is left out.
-- Reads:  calibrated
SELECT
  asset,
  channel,
  lowest AS lo,
  highest AS hi,
  CAST(NULL AS BIGINT) AS allowed,
  CAST(0 AS BIGINT) AS dropped_below,
  CAST(0 AS BIGINT) AS dropped_above
FROM calibrated
WHERE lowest IS NOT NULL
