-- Cells: those on one grid, with the first and the last block that saw them, of supports that pass on the next coarser
-- one: on a finer grid no block shares more. Repeated by Python, once per grid.
-- Reads:  learnt, coarser, the supports that pass on the next coarser grid
-- A row:  one cell of one support.
-- Slots:  :level       the number of the grid
--         :coarse_key  the key of the cell on the grid
SELECT
  support_id,
  CAST(:level AS INTEGER) AS level,
  cell_key,
  CAST(COUNT(*) AS BIGINT) AS visits,
  MIN(block) AS first_block,
  MAX(block) AS last_block,
  MIN(part) AS first_part,
  MAX(part) AS last_part
FROM (
  SELECT vector.support_id AS support_id, :coarse_key AS cell_key, vector.block AS block, vector.part AS part
  FROM learnt AS vector
  JOIN coarser AS good ON good.support_id = vector.support_id
) AS coarse_cell
GROUP BY support_id, cell_key
