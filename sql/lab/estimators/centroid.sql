-- Centroid: the centre of mass of the healthy vectors; all of them, not a sample.
-- Reads:  learnt_points, learnt_counts
-- A row:  one support.
-- Slots:  :means  centre_0 ... centre_(m-1), by estimators/centroid_mean.sql
SELECT point.support_id AS support_id, :means
FROM learnt_points AS point
JOIN (
  SELECT
    support_id,
    points,
    FLOOR(CAST(4611686018427387904 AS DOUBLE) / CAST(points AS DOUBLE)) AS units
  FROM learnt_counts
) AS sized ON sized.support_id = point.support_id
GROUP BY point.support_id, sized.points, sized.units
