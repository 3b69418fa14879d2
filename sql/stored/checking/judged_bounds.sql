-- Judged bounds: the frozen bounds with what a verdict must know beside them (see support/bounds.sql).
-- Reads:  bounds
-- A row:  one channel.
-- Slots:  :bins, :window  B and W of the versions
SELECT
  scale.channel_id AS channel_id,
  scale.support_id AS support_id,
  scale.calibrated_lo AS calibrated_lo,
  scale.calibrated_hi AS calibrated_hi,
  CAST(:bins AS BIGINT) AS bins,
  CAST(:window AS BIGINT) AS window_length
FROM bounds AS scale
