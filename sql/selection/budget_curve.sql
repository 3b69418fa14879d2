-- Budget curve: what the calibration affords at each embedding dimension, under the channel's names.
-- Reads:  channels, budget
-- A row:  one dimension of one channel, in order.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(point.m AS BIGINT) AS m,
  CAST(point.vectors AS BIGINT) AS vectors,
  CAST(point.cells AS BIGINT) AS cells,
  point.floor AS floor,
  point.verdict AS verdict,
  CAST(point.finest_bins AS BIGINT) AS finest_bins,
  point.finest_floor AS finest_floor,
  CAST(point.vectors_needed AS BIGINT) AS vectors_needed
FROM budget AS point
JOIN channels AS named ON named.channel_id = point.channel_id
ORDER BY named.asset, named.channel, point.m
