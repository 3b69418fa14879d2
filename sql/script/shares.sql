-- Shares: the mean share of novel vectors in the blocks of a grid. It is added up in whole parts of one,
-- which are the same in any order.
-- Reads:  blocks
SELECT
  asset,
  channel,
  level,
  level_bins,
  vectors,
  healthy_hi,
  units,
  CAST(
    CAST(SUM(CAST(FLOOR(healthy_hi * units + CAST(5e-1 AS DOUBLE)) AS BIGINT)) OVER (PARTITION BY asset, channel, level) AS BIGINT)
    AS DOUBLE
  ) / (units * CAST(COUNT(*) OVER (PARTITION BY asset, channel, level) AS BIGINT)) AS floor
FROM blocks
