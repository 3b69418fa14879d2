-- Taught: the cells of calibration, where nothing but the support is asked of it: no row per vector is kept.
-- Reads:  learnable
-- A row:  one cell of one channel, or NULL; doubled = 1 if one of its vectors, or a sample without a vector, has the
--         instant of the sample before.
SELECT
  channel_id,
  cell_key,
  MAX(vector.doubled) AS doubled
FROM learnable AS vector
GROUP BY channel_id, cell_key
