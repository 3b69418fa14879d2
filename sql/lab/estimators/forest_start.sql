-- Forest start: every scored vector at the root of every tree of its Isolation Forest.
-- Reads:  scored_points, forest_trees
-- A row:  one scored vector and one tree.
-- Slots:  :point  x_0 ... x_(m-1)
SELECT
  point.channel_id AS channel_id,
  point.support_id AS support_id,
  point.time AS time,
  :point,
  tree.root AS node
FROM scored_points AS point
JOIN forest_trees AS tree ON tree.support_id = point.support_id
