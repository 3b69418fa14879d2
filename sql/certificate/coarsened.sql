-- Coarsened: the cells on the coarser grids of the ladder, with the blocks that saw them. A coarser cell is made of
-- whole finer ones, so its counts are read off those of any finer grid.
-- Reads:  cells, levels
-- A row:  one cell of one support on one grid.
-- Slots:  :coarse_key  the key of the cell on the coarser grid
SELECT
  support_id,
  level,
  coarse_key AS cell_key,
  CAST(SUM(coarse.visits) AS BIGINT) AS visits,
  MIN(coarse.first_block) AS first_block,
  MAX(coarse.last_block) AS last_block
FROM (
  SELECT
    finer.support_id AS support_id,
    step.level AS level,
    finer.visits AS visits,
    finer.first_block AS first_block,
    finer.last_block AS last_block,
    :coarse_key AS coarse_key
  FROM cells AS finer
  CROSS JOIN levels AS step
  WHERE step.level > 0
) AS coarse
GROUP BY support_id, level, coarse_key
