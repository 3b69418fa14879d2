-- First visits: which block saw each cell first, how often, and which came second. Most cells of a fine grid are seen by
-- one block, and only the others are looked up again.
-- Reads:  cells, visits, block_sizes
-- A row:  one cell of one support; second_block is NULL where only one block saw it.
SELECT
  support_id,
  first_block,
  CAST(NULL AS BIGINT) AS second_block,
  visits
FROM cells
WHERE first_block = last_block
UNION ALL
SELECT
  shared.support_id AS support_id,
  shared.first_block AS first_block,
  MIN(CASE WHEN size.pool_block > shared.first_block THEN size.pool_block END) AS second_block,
  CAST(SUM(CASE WHEN size.pool_block = shared.first_block THEN visit.visits ELSE 0 END) AS BIGINT)
    AS visits
FROM (
  SELECT support_id, cell_key, first_block
  FROM cells
  WHERE first_block < last_block
) AS shared
JOIN visits AS visit
  ON visit.support_id = shared.support_id AND visit.cell_key = shared.cell_key
JOIN block_sizes AS size
  ON size.channel_id = visit.channel_id AND size.block_no = visit.block_no
GROUP BY shared.support_id, shared.cell_key, shared.first_block
