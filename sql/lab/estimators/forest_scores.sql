-- Forest scores: 2^(-E / c): E the mean length of the path to the leaf, c that of an average tree (Liu,
-- Ting and Zhou 2008). Paths are summed in integers of 2^-40; rate is ln 2 / (2^40 * trees * c).
-- Reads:  walk, forest_nodes, forests
-- A row:  one scored vector.
SELECT
  placed.channel_id AS channel_id,
  placed.time AS time,
  EXP(-CAST(SUM(leaf.path_units) AS DOUBLE) * grown.rate) AS score
FROM walk AS placed
JOIN forest_nodes AS leaf ON leaf.node = placed.node
JOIN forests AS grown ON grown.support_id = placed.support_id
GROUP BY placed.channel_id, placed.time, grown.rate
