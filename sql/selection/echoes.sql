-- Echoes: what the autocorrelation at one lag is made of, in exact integers: levels about the middle of
-- their range, multiplied and summed. Repeated by Python, once per lag, and stacked.
-- Reads:  lagged
-- A row:  one channel that has a pair at that lag.
-- Slots:  :scale  samples that one row of lagged stands for
--         :lag    in rows of lagged
--         :level  the column with the level that lag ago
SELECT
  channel_id,
  scale,
  lag,
  CAST(COUNT(*) AS BIGINT) AS n_pairs,
  CAST(SUM(now_level) AS BIGINT) AS now_sum,
  CAST(SUM(then_level) AS BIGINT) AS then_sum,
  CAST(SUM(now_level * now_level) AS BIGINT) AS now_squares,
  CAST(SUM(then_level * then_level) AS BIGINT) AS then_squares,
  CAST(SUM(now_level * then_level) AS BIGINT) AS products
FROM (
  SELECT
    channel_id,
    CAST(:scale AS BIGINT) AS scale,
    CAST(:lag AS INTEGER) AS lag,
    CAST(level_0 AS BIGINT) - 8192 AS now_level,
    CAST(:level AS BIGINT) - 8192 AS then_level
  FROM lagged
  WHERE level_0 > 0 AND :level > 0
) AS centred
GROUP BY channel_id, scale, lag
