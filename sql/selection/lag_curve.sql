-- Lag curve: the curve of every channel under its names.
-- Reads:  channels, curve
-- A row:  one lag of one channel, in order; informative = 1 where the information is more than chance.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(point.delay AS BIGINT) AS delay,
  CAST(point.n_pairs AS BIGINT) AS n_pairs,
  CAST(point.occupied AS BIGINT) AS occupied,
  point.ami AS ami,
  point.ami_corrected AS ami_corrected,
  point.acf AS acf,
  point.informative AS informative
FROM curve AS point
JOIN channels AS named ON named.channel_id = point.channel_id
ORDER BY named.asset, named.channel, point.delay
