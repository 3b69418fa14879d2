-- Support: S = { Phi(v) | v in D_ref }, the cells that healthy operation visits (Eq. 3).
-- Reads:  calibration_vectors, bounds
-- A row:  one cell of one support.
SELECT DISTINCT
  scale.support_id AS support_id,
  vector.cell_key AS cell_key
FROM calibration_vectors AS vector
JOIN bounds AS scale ON scale.channel_id = vector.channel_id
WHERE vector.calibration_vector = 1 AND vector.cell_key IS NOT NULL
