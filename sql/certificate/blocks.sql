-- Blocks: had this block been left out of calibration, how many of its vectors would have been novel?
-- Those in cells that no other block visited (method, section 5). Their share is the healthy HI of
-- the block. share_units is the share in whole units of 2^-62 * blocks, so that sums are sums of
-- integers, the same in any order.
-- Reads:  block_sizes, cells
-- A row:  one block.
SELECT
  channel_id,
  support_id,
  block,
  pool_block,
  pool_blocks,
  first_time,
  last_time,
  vectors,
  novel,
  CAST(novel AS DOUBLE) / CAST(vectors AS DOUBLE) AS healthy_hi,
  units,
  CAST(
    FLOOR(CAST(novel AS DOUBLE) / CAST(vectors AS DOUBLE) * units + CAST(5e-1 AS DOUBLE)) AS BIGINT
  ) AS share_units
FROM (
  SELECT
    size.channel_id AS channel_id,
    size.support_id AS support_id,
    size.block AS block,
    size.pool_block AS pool_block,
    size.pool_blocks AS pool_blocks,
    size.first_time AS first_time,
    size.last_time AS last_time,
    size.vectors AS vectors,
    CASE WHEN exclusive.hit = 1 THEN exclusive.visits ELSE 0 END AS novel,
    FLOOR(CAST(4611686018427387904 AS DOUBLE) / CAST(size.pool_blocks AS DOUBLE)) AS units
  FROM block_sizes AS size
  LEFT JOIN (
    SELECT support_id, first_block, CAST(SUM(cell.visits) AS BIGINT) AS visits, 1 AS hit
    FROM cells AS cell
    WHERE first_block = last_block
    GROUP BY support_id, first_block
  ) AS exclusive ON exclusive.support_id = size.support_id AND exclusive.first_block = size.pool_block
) AS counted
