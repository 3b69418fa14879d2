-- Block sizes: the blocks that hold vectors, numbered from 0 in their channel (block) and over all
-- members of the pool (pool_block); place is channel and block as one number.
-- Reads:  visits
-- A row:  one block.
SELECT
  channel_id,
  support_id,
  block_no,
  vectors,
  first_time,
  last_time,
  CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY block_no) AS BIGINT) - 1 AS block,
  CAST(ROW_NUMBER() OVER (PARTITION BY support_id ORDER BY channel_id, block_no) AS BIGINT) - 1
    AS pool_block,
  CAST(COUNT(*) OVER (PARTITION BY support_id) AS BIGINT) AS pool_blocks,
  CAST(channel_id AS BIGINT) * CAST(2147483648 AS BIGINT) + block_no AS place
FROM (
  SELECT
    channel_id,
    support_id,
    block_no,
    CAST(SUM(visits) AS BIGINT) AS vectors,
    MIN(visit.first_time) AS first_time,
    MAX(visit.last_time) AS last_time
  FROM visits AS visit
  GROUP BY channel_id, support_id, block_no
) AS summed
