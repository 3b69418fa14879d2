-- Mixture densities: the logarithm of what each Gaussian component says of a vector: log of its weight
-- and of N(x | mean, covariance). With the Cholesky factor U of the precision, y = x U - mean U and
-- log N = log det U - (m log(2 pi) + y y) / 2; bias holds all that does not depend on x.
-- Reads:  scored_points, mixture
-- A row:  one scored vector and one component.
-- Slots:  :projections     y_0 ... y_(m-1)
--         :squared_length  y y
SELECT
  channel_id,
  time,
  component,
  bias - CAST(5e-1 AS DOUBLE) * (:squared_length) AS log_density
FROM (
  SELECT
    vector.channel_id AS channel_id,
    vector.time AS time,
    fitted.component AS component,
    fitted.bias AS bias,
    :projections
  FROM scored_points AS vector
  JOIN mixture AS fitted ON fitted.support_id = vector.support_id
) AS projected
