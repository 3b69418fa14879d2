-- Forest step: one level down; a leaf leads to itself. scikit-learn compares coordinates rounded to
-- 32-bit floats; threshold is the largest double that so rounded is still on the lower side, which is
-- the same decision for every coordinate. Repeated by Python, once per level.
-- Reads:  walk, forest_nodes
-- A row:  one scored vector and one tree.
-- Slots:  :point       x_0 ... x_(m-1)
--         :coordinate  the one that the node asks for
SELECT
  point.channel_id AS channel_id,
  point.support_id AS support_id,
  point.time AS time,
  :point,
  CASE WHEN :coordinate <= fork.threshold THEN fork.lower_node ELSE fork.upper_node END AS node
FROM walk AS point
JOIN forest_nodes AS fork ON fork.node = point.node
