-- Chances: p(k), the chance that a cell of k blocks lies wholly within g of a block of its own (alarms, section 3).
-- Repeated by Python, once per k.
-- Reads:  block_sizes
-- A row:  one channel; chance_units is p(k) in units of 2^-30, so that sums are sums of integers.
-- Slots:  :visited_blocks  k
--         :g
--         :product         the factors of alarms/chance_factor.sql
SELECT
  channel_id,
  CAST(:visited_blocks AS BIGINT) AS visited_blocks,
  MAX(near.blocks) AS blocks,
  CAST(
    FLOOR(
      CAST(CAST(SUM(near.units) AS BIGINT) AS DOUBLE) / CAST(MAX(near.blocks) AS DOUBLE) + CAST(5e-1 AS DOUBLE)
    ) AS BIGINT
  ) AS chance_units
FROM (
  SELECT
    channel_id,
    blocks,
    CAST(FLOOR(:product * CAST(1073741824 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT) AS units
  FROM (
    SELECT
      channel_id,
      blocks,
      CASE WHEN block < :g THEN block ELSE :g END
        + CASE WHEN blocks - 1 - block < :g THEN blocks - 1 - block ELSE :g END AS near_blocks
    FROM (
      SELECT
        channel_id,
        block,
        CAST(COUNT(*) OVER (PARTITION BY channel_id) AS BIGINT) AS blocks
      FROM block_sizes
    ) AS counted
  ) AS placed
) AS near
GROUP BY channel_id
