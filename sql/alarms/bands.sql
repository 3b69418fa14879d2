-- Bands: where calibration was, by the newest coordinate, and how much of that no block farther than g away vouches for:
-- what alarms/buffered.sql counts by blocks (alarms, section 5).
-- Reads:  visits, block_sizes, cells, bounds
-- A row:  one band of one channel that calibration visited.
-- Slots:  :g     how far away a block must be to vouch for a cell
--         :band  the expression of alarms/band.sql
SELECT
  channel_id,
  CAST(:g AS BIGINT) AS g,
  band,
  CAST(SUM(placed.visits) AS BIGINT) AS visits,
  CAST(SUM(placed.novel_buffered) AS BIGINT) AS novel_buffered
FROM (
  SELECT
    visit.channel_id AS channel_id,
    :band AS band,
    visit.visits AS visits,
    CASE
      WHEN cell.first_block >= size.pool_block - :g
        AND cell.first_block >= own.first_block
        AND cell.last_block <= size.pool_block + :g
        AND cell.last_block <= own.last_block THEN visit.visits
      ELSE 0
    END AS novel_buffered
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
GROUP BY channel_id, band
