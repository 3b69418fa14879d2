-- All healthy: 1 where every sample of a vector is of the healthy period.
-- Slots:  :span  (m - 1) tau, in samples
MIN(calibrating) OVER (
  PARTITION BY asset, channel ORDER BY time ROWS BETWEEN :span PRECEDING AND CURRENT ROW
)
