-- Chances: p(k), the chance that a cell of k blocks lies wholly within g of a block of its own (alarms, section 3), for
-- each k of a channel's cells. Beyond 2 g + 1 blocks no cell can.
-- Reads:  block_sizes, exclusive_cells
-- A row:  one number of blocks of one channel; chance_units is p(k) in units of 2^-30, so that sums are sums of integers.
-- Slots:  :g
--         :most     2 g + 1
--         :product  by visited_blocks, the factors of alarms/chance_factor.sql
SELECT
  near.channel_id AS channel_id,
  near.visited_blocks AS visited_blocks,
  CAST(
    FLOOR(
      CAST(CAST(SUM(near.units) AS BIGINT) AS DOUBLE) / CAST(MAX(near.blocks) AS DOUBLE) + CAST(5e-1 AS DOUBLE)
    ) AS BIGINT
  ) AS chance_units
FROM (
  SELECT
    channel_id,
    visited_blocks,
    blocks,
    CAST(FLOOR(:product * CAST(1073741824 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT) AS units
  FROM (
    SELECT
      counted.channel_id AS channel_id,
      counted.blocks AS blocks,
      cell_count.visited_blocks AS visited_blocks,
      CASE WHEN counted.block < :g THEN counted.block ELSE :g END
        + CASE
          WHEN counted.blocks - 1 - counted.block < :g THEN counted.blocks - 1 - counted.block
          ELSE :g
        END AS near_blocks
    FROM (
      SELECT
        channel_id,
        block,
        CAST(COUNT(*) OVER (PARTITION BY channel_id) AS BIGINT) AS blocks
      FROM block_sizes
    ) AS counted
    JOIN exclusive_cells AS cell_count ON cell_count.channel_id = counted.channel_id
    WHERE cell_count.visited_blocks <= :most
  ) AS near_range
) AS near
GROUP BY near.channel_id, near.visited_blocks
