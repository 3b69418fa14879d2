-- Finest: the finest grid of the ladder whose floor passes, where there are vectors enough to tell. A floor
-- equal to the target passes: 2^-40 allows for the division.
-- Reads:  ladder, spread
-- A row:  one support that has such a grid.
-- Slots:  :target_floor
--         :least_vectors  calibration vectors below which a floor promises nothing
SELECT grid.support_id AS support_id, MAX(grid.level_bins) AS finest_bins
FROM ladder AS grid
JOIN spread AS whole ON whole.support_id = grid.support_id
WHERE grid.floor - CAST(:target_floor AS DOUBLE) <= CAST(1 AS DOUBLE) / CAST(1099511627776 AS DOUBLE)
  AND whole.vectors >= :least_vectors
GROUP BY grid.support_id
