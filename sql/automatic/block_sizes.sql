-- Block sizes: the blocks of vectors; as certificate/block_sizes.sql, with a number that needs no order.
-- Reads:  learnt
-- A row:  one block.
SELECT
  channel_id,
  support_id,
  block_no,
  block AS pool_block,
  vectors,
  CAST(COUNT(*) OVER (PARTITION BY support_id) AS BIGINT) AS pool_blocks
FROM (
  SELECT channel_id, support_id, block_no, block, CAST(COUNT(*) AS BIGINT) AS vectors
  FROM learnt
  GROUP BY channel_id, support_id, block_no, block
) AS counted
