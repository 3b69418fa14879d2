-- Cycle curve: the autocorrelation of every channel at long lags under its names, from finer to coarser
-- scales.
-- Reads:  channels, autocorrelation
-- A row:  one lag of one scale of one channel, in order; lag and scale in samples.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(point.scale AS BIGINT) AS scale,
  CAST(point.delay AS BIGINT) * point.scale AS delay,
  CAST(point.n_pairs AS BIGINT) AS n_pairs,
  point.acf AS acf
FROM autocorrelation AS point
JOIN channels AS named ON named.channel_id = point.channel_id
ORDER BY named.asset, named.channel, point.scale, point.delay
