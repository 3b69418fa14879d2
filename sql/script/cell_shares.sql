-- Cell shares: the share that a cell adds in the first block that visits it; a second one takes it away.
-- Reads:  blocks, visits
SELECT
  visit.asset AS asset,
  visit.channel AS channel,
  visit.block AS block,
  visit.second_block AS second_block,
  CAST(
    FLOOR(CAST(visit.visits AS DOUBLE) / CAST(size.vectors AS DOUBLE) * size.units + CAST(5e-1 AS DOUBLE)) AS BIGINT
  ) AS share_units
FROM (
  SELECT
    asset,
    channel,
    block,
    visits,
    CAST(ROW_NUMBER() OVER (PARTITION BY asset, channel, cell_key ORDER BY block) AS BIGINT) AS turn,
    LAG(block, 1) OVER (PARTITION BY asset, channel, cell_key ORDER BY block DESC) AS second_block
  FROM visits
) AS visit
JOIN blocks AS size ON size.asset = visit.asset AND size.channel = visit.channel AND size.block = visit.block
WHERE visit.turn = 1 AND size.level = 0
