-- Cell shares: what each cell adds to the healthy HI of the block that saw it first, as long as no second
-- block has seen it; in the units of blocks.
-- Reads:  first_visits, blocks
-- A row:  one cell of one support; second_block is NULL where only one block saw it.
SELECT
  cell.support_id AS support_id,
  cell.first_block AS first_block,
  cell.second_block AS second_block,
  CAST(
    FLOOR(
      CAST(cell.visits AS DOUBLE) / CAST(opening.vectors AS DOUBLE) * opening.units
      + CAST(5e-1 AS DOUBLE)
    ) AS BIGINT
  ) AS share_units
FROM first_visits AS cell
JOIN blocks AS opening
  ON opening.support_id = cell.support_id AND opening.pool_block = cell.first_block
