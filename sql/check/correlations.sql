-- Correlations: the autocorrelation of the codes at each lag, over the quarters together, each about its
-- own mean. A quarter must hold a lag twice, or the lag is left out.
-- Reads:  lag_sums
-- A row:  one lag, in blocks, of one channel at one scale.
SELECT
  joint.channel_id AS channel_id,
  joint.scale AS scale,
  joint.lag_no AS lag_no,
  CAST(joint.covariance AS DOUBLE)
    / SQRT(CAST(joint.early_variance AS DOUBLE) * CAST(joint.late_variance AS DOUBLE))
    AS correlation
FROM (
  SELECT
    part.channel_id AS channel_id,
    part.scale AS scale,
    part.lag_no AS lag_no,
    CAST(SUM(part.pairs) AS BIGINT) AS pairs,
    CAST(SUM(part.covariance) AS BIGINT) AS covariance,
    CAST(SUM(part.early_variance) AS BIGINT) AS early_variance,
    CAST(SUM(part.late_variance) AS BIGINT) AS late_variance
  FROM lag_sums AS part
  GROUP BY part.channel_id, part.scale, part.lag_no
) AS joint
WHERE joint.pairs >= 4 * joint.lag_no AND joint.early_variance > 0 AND joint.late_variance > 0
