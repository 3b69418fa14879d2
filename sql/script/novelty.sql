-- Novelty: a(t) = 1 where the cell of a vector is not in the support (Eq. 4).
-- Reads:  vectors, support
SELECT
  vector.asset AS asset,
  vector.channel AS channel,
  vector.time AS time,
  vector.cell_key AS cell_key,
  vector.out_of_range AS out_of_range,
  vector.straddling AS straddling,
  CASE WHEN healthy.hit = 1 THEN 0 ELSE 1 END AS novel
FROM vectors AS vector
LEFT JOIN (
  SELECT asset, channel, cell_key, 1 AS hit
  FROM support
) AS healthy
  ON healthy.asset = vector.asset
  AND healthy.channel = vector.channel
  AND healthy.cell_key = vector.cell_key
WHERE vector.cell_key IS NOT NULL
  AND vector.calibration_vector = 0
  AND vector.time >= vector.first_scored
