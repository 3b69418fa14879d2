-- Cell shares, of cells that know which blocks saw them first and second (streams/cells.sql): what each adds to the
-- healthy HI of the block that saw it first, as long as no second block has seen it; see certificate/cell_shares.sql.
-- Reads:  cells, block_sizes, blocks
-- A row:  one cell of one support; second_block is NULL where only one block saw it.
SELECT
  cell.support_id AS support_id,
  cell.first_block AS first_block,
  CASE WHEN second.hit = 1 THEN second.pool_block END AS second_block,
  CAST(
    FLOOR(
      CAST(cell.first_visits AS DOUBLE) / CAST(opening.vectors AS DOUBLE) * opening.units
      + CAST(5e-1 AS DOUBLE)
    ) AS BIGINT
  ) AS share_units
FROM cells AS cell
JOIN blocks AS opening
  ON opening.support_id = cell.support_id AND opening.pool_block = cell.first_block
LEFT JOIN (
  SELECT place, pool_block, 1 AS hit
  FROM block_sizes
) AS second ON second.place = cell.second_place
