-- Cells: the support with what calibration knows of each cell: how often, and who saw it first and last.
-- Reads:  visits, block_sizes
-- A row:  one cell of one support.
SELECT
  visit.support_id AS support_id,
  visit.cell_key AS cell_key,
  CAST(SUM(visit.visits) AS BIGINT) AS visits,
  MIN(size.pool_block) AS first_block,
  MAX(size.pool_block) AS last_block,
  MIN(visit.first_time) AS first_time,
  MAX(visit.last_time) AS last_time
FROM visits AS visit
JOIN block_sizes AS size
  ON size.channel_id = visit.channel_id AND size.block_no = visit.block_no
GROUP BY visit.support_id, visit.cell_key
