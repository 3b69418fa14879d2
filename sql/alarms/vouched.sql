-- Vouched: how near the blocks are that vouch for what a block of calibration visited, by the newest coordinate (alarms,
-- sections 2 and 5). Blocks are numbered over all members of a support, so a cell that another member visited is always
-- vouched for.
-- Reads:  visits, block_sizes, cells, bounds
-- A row:  one band of one block of one channel, and one reach: no block farther away than that has visited these cells;
--         NULL where another member has.
-- Slots:  :band  the expression of alarms/band.sql
SELECT
  channel_id,
  block,
  vectors,
  band,
  reach,
  CAST(SUM(placed.visits) AS BIGINT) AS visits
FROM (
  SELECT
    size.channel_id AS channel_id,
    size.block AS block,
    size.vectors AS vectors,
    :band AS band,
    CASE
      WHEN cell.first_block < own.first_block OR cell.last_block > own.last_block THEN NULL
      WHEN size.pool_block - cell.first_block > cell.last_block - size.pool_block
        THEN size.pool_block - cell.first_block
      ELSE cell.last_block - size.pool_block
    END AS reach,
    visit.visits AS visits
  FROM visits AS visit
  JOIN bounds AS scale ON scale.channel_id = visit.channel_id
  JOIN block_sizes AS size ON size.channel_id = visit.channel_id AND size.block_no = visit.block_no
  JOIN (
    SELECT channel_id, MIN(pool_block) AS first_block, MAX(pool_block) AS last_block
    FROM block_sizes
    GROUP BY channel_id
  ) AS own ON own.channel_id = size.channel_id
  JOIN cells AS cell ON cell.support_id = visit.support_id AND cell.cell_key = visit.cell_key
) AS placed
GROUP BY channel_id, block, vectors, band, reach
