-- Support: the cells that healthy operation visits (Eq. 3).
-- Reads:  visits
SELECT
  asset,
  channel,
  cell_key,
  CAST(SUM(visit.visits) AS BIGINT) AS visits,
  MIN(block) AS first_block,
  MAX(block) AS last_block
FROM visits AS visit
GROUP BY asset, channel, cell_key
