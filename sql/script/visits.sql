-- Visits: how often each block of W healthy vectors visits each cell; eight blocks at least.
-- Reads:  learnt
SELECT
  asset,
  channel,
  block,
  cell_key,
  CAST(COUNT(*) AS BIGINT) AS visits,
  MIN(time) AS first_time,
  MAX(time) AS last_time
FROM learnt
GROUP BY asset, channel, block, cell_key
