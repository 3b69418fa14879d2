-- Finest: the finest grid of the ladder whose floor passes. A floor equal to the target passes:
-- 2^-40 allows for the division.
-- Reads:  ladder
-- A row:  one support that has such a grid.
-- Slots:  :target_floor
SELECT support_id, MAX(level_bins) AS finest_bins
FROM ladder
WHERE floor - CAST(:target_floor AS DOUBLE) <= CAST(1 AS DOUBLE) / CAST(1099511627776 AS DOUBLE)
GROUP BY support_id
