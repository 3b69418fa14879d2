-- Run-up: what lies before the first scored vector. Where a channel has no missing sample, the number
-- of a vector follows from its position, and the vectors need not be put in order a second time.
-- Reads:  samples, bounds
-- A row:  one channel.
SELECT
  scale.channel_id AS channel_id,
  CAST(SUM(CASE WHEN sampled.time < scale.first_scored THEN 1 ELSE 0 END) AS BIGINT) AS samples_before,
  CAST(SUM(CASE WHEN sampled.value IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS missing_samples
FROM samples AS sampled
JOIN bounds AS scale ON scale.channel_id = sampled.channel_id
GROUP BY scale.channel_id
