-- Forest scores: 2^(-E / c): E the mean length of the path to the leaf, c that of an average tree (Liu,
-- Ting and Zhou 2008). Paths are summed in integers of 2^-40; rate is ln 2 / (2^40 * trees * c).
-- Reads:  walk, forest_nodes, forests
-- A row:  one scored vector.
SELECT
  point.channel_id AS channel_id,
  point.time AS time,
  EXP(-CAST(SUM(leaf.path_units) AS DOUBLE) * grown.rate) AS score
FROM walk AS point
JOIN forest_nodes AS leaf ON leaf.node = point.node
JOIN forests AS grown ON grown.support_id = point.support_id
GROUP BY point.channel_id, point.time, grown.rate
