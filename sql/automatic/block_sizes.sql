-- Block sizes: the blocks of vectors; as certificate/block_sizes.sql, with a number that needs no order.
-- Reads:  learnt
-- A row:  one block.
SELECT
  channel_id,
  support_id,
  block_no,
  block AS pool_block,
  part,
  vectors
FROM (
  SELECT channel_id, support_id, block_no, block, part, CAST(COUNT(*) AS BIGINT) AS vectors
  FROM learnt
  GROUP BY channel_id, support_id, block_no, block, part
) AS counted
