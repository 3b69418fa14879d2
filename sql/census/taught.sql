-- Taught: the cells of calibration, where nothing but the support is asked of it: no row per vector is kept.
-- Reads:  learnable
-- A row:  one cell of one channel, or NULL; doubled = 1 for those of its vectors, or samples without a vector, that have
--         the instant of the sample before.
SELECT DISTINCT channel_id, cell_key, doubled
FROM learnable
