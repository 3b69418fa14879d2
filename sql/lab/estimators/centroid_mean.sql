-- Centroid mean: one coordinate of the centre of mass; sums are sums of integers, in units so small that
-- all points together just fit into 64 bits. Learnt coordinates lie between 0 and 1.
-- Slots:  :coordinate  x_k
CAST(
  SUM(CAST(FLOOR(:coordinate * sized.units + CAST(5e-1 AS DOUBLE)) AS BIGINT)) AS DOUBLE
) / (sized.units * CAST(sized.points AS DOUBLE))
