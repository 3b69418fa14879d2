-- Member sizes: the members of a pool that taught, each as one block (both sides, section 6): what the certificate leaves
-- out then is a whole machine.
-- Reads:  block_sizes
-- A row:  one channel that taught, as certificate/block_sizes.sql has blocks.
SELECT
  channel_id,
  support_id,
  CAST(0 AS BIGINT) AS block_no,
  CAST(SUM(part.vectors) AS BIGINT) AS vectors,
  MIN(part.first_time) AS first_time,
  MAX(part.last_time) AS last_time,
  CAST(0 AS BIGINT) AS block,
  CAST(ROW_NUMBER() OVER (PARTITION BY support_id ORDER BY channel_id) AS BIGINT) - 1 AS pool_block,
  CAST(COUNT(*) OVER (PARTITION BY support_id) AS BIGINT) AS pool_blocks
FROM block_sizes AS part
GROUP BY channel_id, support_id
