-- Centroid scores: the Euclidean distance to the centre of mass of the healthy vectors.
-- Reads:  scored_points, centroid
-- A row:  one scored vector.
-- Slots:  :squared_distance  the sum of the squared coordinates
SELECT
  vector.channel_id AS channel_id,
  vector.time AS time,
  SQRT(:squared_distance) AS score
FROM scored_points AS vector
JOIN centroid AS fitted ON fitted.support_id = vector.support_id
