-- Codes: the bin of each sample (Phi): 0 missing, 1 below the range, its bins, above it.
-- Reads:  history, bounds
-- Slots:  :code     the code of a sample
--         :carried  columns that travel along
SELECT asset, channel, time, :code AS code, calibrating, first_scored, value, :carried
FROM (
  SELECT
    sampled.asset AS asset,
    sampled.channel AS channel,
    sampled.time AS time,
    sampled.value AS value,
    sampled.calibrating AS calibrating,
    CASE WHEN scale.calibrated_lo IS NOT NULL THEN sampled.first_scored END AS first_scored,
    scale.calibrated_lo AS lo,
    scale.calibrated_hi AS hi
  FROM history AS sampled
  JOIN bounds AS scale ON scale.asset = sampled.asset AND scale.channel = sampled.channel
) AS ranged
