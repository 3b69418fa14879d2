-- Cells: the support with what calibration knows of each cell: who saw it first, who saw it again.
-- Reads:  visits, block_sizes
-- A row:  one cell of one support. second_block is NULL where only one block saw the cell;
--         first_visits counts the visits of the first block.
SELECT
  support_id,
  cell_key,
  CAST(SUM(seen.visits) AS BIGINT) AS visits,
  MIN(pool_block) AS first_block,
  MIN(CASE WHEN occurrence = 2 THEN pool_block END) AS second_block,
  MAX(pool_block) AS last_block,
  CAST(SUM(CASE WHEN occurrence = 1 THEN seen.visits ELSE 0 END) AS BIGINT) AS first_visits,
  MIN(seen.first_time) AS first_time,
  MAX(seen.last_time) AS last_time
FROM (
  SELECT
    visit.support_id AS support_id,
    visit.cell_key AS cell_key,
    visit.visits AS visits,
    visit.first_time AS first_time,
    visit.last_time AS last_time,
    size.pool_block AS pool_block,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY visit.support_id, visit.cell_key ORDER BY size.pool_block
      ) AS BIGINT
    ) AS occurrence
  FROM visits AS visit
  JOIN block_sizes AS size
    ON size.channel_id = visit.channel_id AND size.block_no = visit.block_no
) AS seen
GROUP BY support_id, cell_key
