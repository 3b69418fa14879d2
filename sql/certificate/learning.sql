-- Learning curve: had calibration ended with this block, how many vectors and cells would it hold and
-- what would its floor be? A cell adds its first block's visits to the novel ones from that block on,
-- until a second block sees it.
-- Reads:  blocks, cell_shares
-- A row:  one block, in the order of the pool.
SELECT
  support_id,
  pool_block,
  learned_vectors,
  learned_cells,
  CAST(novel_units AS DOUBLE) / (units * CAST(pool_block + 1 AS DOUBLE)) AS learned_floor
FROM (
  SELECT
    block.support_id AS support_id,
    block.pool_block AS pool_block,
    block.units AS units,
    CAST(
      SUM(block.vectors) OVER (
        PARTITION BY block.support_id
        ORDER BY block.pool_block
        ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS learned_vectors,
    CAST(
      SUM(CASE WHEN entered.hit = 1 THEN entered.new_cells ELSE 0 END) OVER (
        PARTITION BY block.support_id
        ORDER BY block.pool_block
        ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS learned_cells,
    CAST(
      SUM(
        CASE WHEN entered.hit = 1 THEN entered.share_units ELSE 0 END
        - CASE WHEN shared.hit = 1 THEN shared.share_units ELSE 0 END
      ) OVER (
        PARTITION BY block.support_id
        ORDER BY block.pool_block
        ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
      ) AS BIGINT
    ) AS novel_units
  FROM blocks AS block
  LEFT JOIN (
    SELECT
      cell.support_id AS support_id,
      cell.first_block AS pool_block,
      CAST(COUNT(*) AS BIGINT) AS new_cells,
      CAST(SUM(cell.share_units) AS BIGINT) AS share_units,
      1 AS hit
    FROM cell_shares AS cell
    GROUP BY cell.support_id, cell.first_block
  ) AS entered
    ON entered.support_id = block.support_id AND entered.pool_block = block.pool_block
  LEFT JOIN (
    SELECT
      cell.support_id AS support_id,
      cell.second_block AS pool_block,
      CAST(SUM(cell.share_units) AS BIGINT) AS share_units,
      1 AS hit
    FROM cell_shares AS cell
    WHERE cell.second_block IS NOT NULL
    GROUP BY cell.support_id, cell.second_block
  ) AS shared
    ON shared.support_id = block.support_id AND shared.pool_block = block.pool_block
) AS running
