-- Coarsened: the support on coarser grids, each of which joins bins of the one before two by two.
-- Reads:  support, levels
-- Slots:  :coarse_key  the key of a cell on a coarser grid
SELECT
  asset,
  channel,
  level,
  coarse_key,
  CAST(SUM(coarse.visits) AS BIGINT) AS visits,
  MIN(coarse.first_block) AS block,
  MAX(coarse.last_block) AS last_block
FROM (
  SELECT
    finer.asset AS asset,
    finer.channel AS channel,
    step.level AS level,
    finer.visits AS visits,
    finer.first_block AS first_block,
    finer.last_block AS last_block,
    :coarse_key AS coarse_key
  FROM support AS finer
  CROSS JOIN levels AS step
) AS coarse
GROUP BY asset, channel, level, coarse_key
