-- Buffered: u_b, the vectors of a block whose cell no block farther than g away has visited (alarms, section 2).
-- Reads:  block_sizes, vouched
-- A row:  one block of one channel.
-- Slots:  :g  how far away a block must be to vouch for a cell
SELECT
  size.channel_id AS channel_id,
  CAST(:g AS BIGINT) AS g,
  size.block AS block,
  size.vectors AS vectors,
  CASE WHEN near.hit = 1 THEN near.visits ELSE 0 END AS novel_buffered
FROM block_sizes AS size
LEFT JOIN (
  SELECT channel_id, block, CAST(SUM(part.visits) AS BIGINT) AS visits, 1 AS hit
  FROM vouched AS part
  WHERE reach <= :g
  GROUP BY channel_id, block
) AS near ON near.channel_id = size.channel_id AND near.block = size.block
