-- Buffered: u_b, the vectors of a block whose cell no block farther than g away has visited (alarms, section 2). Blocks
-- are numbered over all members of a support, so a cell that another member visited is never counted.
-- Reads:  visits, block_sizes, cells
-- A row:  one block of one channel.
-- Slots:  :g  how far away a block must be to vouch for a cell
SELECT
  size.channel_id AS channel_id,
  CAST(:g AS BIGINT) AS g,
  size.block AS block,
  size.vectors AS vectors,
  CAST(
    SUM(
      CASE
        WHEN cell.first_block >= size.pool_block - :g
          AND cell.first_block >= own.first_block
          AND cell.last_block <= size.pool_block + :g
          AND cell.last_block <= own.last_block THEN visit.visits
        ELSE 0
      END
    ) AS BIGINT
  ) AS novel_buffered
FROM visits AS visit
JOIN block_sizes AS size ON size.channel_id = visit.channel_id AND size.block_no = visit.block_no
JOIN (
  SELECT channel_id, MIN(pool_block) AS first_block, MAX(pool_block) AS last_block
  FROM block_sizes
  GROUP BY channel_id
) AS own ON own.channel_id = size.channel_id
JOIN cells AS cell ON cell.support_id = visit.support_id AND cell.cell_key = visit.cell_key
GROUP BY size.channel_id, size.block, size.vectors
