-- Calibration codes: the samples of calibration alone, coded (Phi, method section 3).
-- Reads:  samples, bounds, calibration
-- A row:  one calibration sample.
-- Slots:  :code  the expression of support/code.sql, cast to the narrowest integer that holds it
SELECT channel_id, time, :code AS code
FROM (
  SELECT
    sampled.channel_id AS channel_id,
    sampled.time AS time,
    sampled.value AS value,
    scale.calibrated_lo AS lo,
    scale.calibrated_hi AS hi
  FROM samples AS sampled
  JOIN bounds AS scale ON scale.channel_id = sampled.channel_id
  JOIN calibration AS piece ON piece.channel_id = sampled.channel_id
  WHERE sampled.time BETWEEN piece.time_from AND piece.time_to
) AS ranged
