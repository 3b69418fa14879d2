-- Vouched: how near the blocks are that vouch for what a block of calibration visited, by the newest coordinate (alarms,
-- sections 2 and 5). Only cells are looked at that no other member of the support visited, which would always vouch for
-- them, and that lie within twice as many blocks as anybody asks for: of all others some block is farther away.
-- Reads:  visits, block_sizes, cells, bounds
-- A row:  one band of one block of one channel, and one reach: no block farther away than that has visited these cells.
-- Slots:  :band  the expression of alarms/band.sql
--         :far   how far away a block is at most that is asked for
SELECT
  channel_id,
  block,
  band,
  reach,
  CAST(SUM(band_reach.visits) AS BIGINT) AS visits
FROM (
  SELECT
    size.channel_id AS channel_id,
    size.block AS block,
    :band AS band,
    CASE
      WHEN size.pool_block - cell.first_block > cell.last_block - size.pool_block
        THEN size.pool_block - cell.first_block
      ELSE cell.last_block - size.pool_block
    END AS reach,
    visit.visits AS visits
  FROM visits AS visit
  JOIN (
    SELECT support_id, cell_key, first_block, last_block
    FROM cells
    WHERE first_channel = last_channel AND last_block - first_block <= 2 * :far
  ) AS cell ON cell.support_id = visit.support_id AND cell.cell_key = visit.cell_key
  JOIN block_sizes AS size ON size.channel_id = visit.channel_id AND size.block_no = visit.block_no
  JOIN bounds AS scale ON scale.channel_id = visit.channel_id
) AS band_reach
WHERE reach <= :far
GROUP BY channel_id, block, band, reach
