-- First visits, of cells that know which block came second; as certificate/first_visits.sql. For DuckDB, which finds
-- that while it groups visits (streams/second_place.sql): they are not looked at again. Proof: a place is one block
-- (block_sizes), and a cell has one row of visits for each.
-- Reads:  cells, block_sizes
-- A row:  one cell of one support; second_block is NULL where only one block saw it.
SELECT
  cell.support_id AS support_id,
  cell.first_block AS first_block,
  CASE WHEN second.hit = 1 THEN second.pool_block END AS second_block,
  cell.opening_visits AS visits
FROM cells AS cell
LEFT JOIN (
  SELECT place, pool_block, 1 AS hit
  FROM block_sizes
) AS second ON second.place = cell.second_place
