-- Drawn points: the sample of learnt points that an estimator is fitted on; their numbers are drawn by
-- the caller, with a seed.
-- Reads:  learnt_points, drawn
-- A row:  one point, in order.
-- Slots:  :point  x_0 ... x_(m-1)
SELECT point.support_id AS support_id, :point
FROM learnt_points AS point
JOIN drawn AS chosen
  ON chosen.support_id = point.support_id AND chosen.number = point.number
ORDER BY point.support_id, point.number
