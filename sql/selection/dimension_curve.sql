-- Dimension curve: false nearest neighbours and Cao's E1 and E2 of every channel under its names.
-- Reads:  channels, dimensions
-- A row:  one dimension of one channel, in order; false_share is NULL where no vector has a neighbour.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(point.m AS BIGINT) AS m,
  CAST(point.reference_vectors AS BIGINT) AS reference_vectors,
  CAST(point.neighbours AS BIGINT) AS neighbours,
  CAST(point.skipped AS BIGINT) AS skipped,
  CAST(point.false_neighbours AS BIGINT) AS false_neighbours,
  CAST(point.false_neighbours AS DOUBLE)
  / NULLIF(CAST(point.neighbours AS DOUBLE), CAST(0 AS DOUBLE)) AS false_share,
  point.e1 AS e1,
  point.e2 AS e2
FROM dimensions AS point
JOIN channels AS named ON named.channel_id = point.channel_id
ORDER BY named.asset, named.channel, point.m
