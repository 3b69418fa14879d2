-- Support: S = { Phi(v) | v in D_ref }, the cells that healthy operation visits (Eq. 3).
-- Reads:  learnable, bounds
-- A row:  one cell of one support.
SELECT DISTINCT
  scale.support_id AS support_id,
  vector.cell_key AS cell_key
FROM learnable AS vector
JOIN bounds AS scale ON scale.channel_id = vector.channel_id
