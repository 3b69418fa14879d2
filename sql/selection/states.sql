-- States: how many distinct vectors of d coordinates there are, and how many vectors. Repeated by Python, once
-- per dimension, and stacked.
-- Reads:  patterns
-- A row:  one dimension of one channel.
-- Slots:  :d  coordinates
SELECT
  channel_id,
  CAST(:d AS INTEGER) AS m,
  CAST(COUNT(*) AS BIGINT) AS states,
  CAST(SUM(pattern.visits) AS BIGINT) AS vectors
FROM patterns AS pattern
GROUP BY channel_id
