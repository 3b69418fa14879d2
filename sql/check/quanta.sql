-- Quanta: the smallest difference between two values that occur, which is the resolution of a signal that
-- was digitised. Differences below a billionth of the range are rounding, not resolution.
-- Reads:  distinct_values, movements
-- A row:  one channel that has a value; quantum is NULL where all values looked at are one.
SELECT
  level.channel_id AS channel_id,
  CAST(COUNT(*) AS BIGINT) AS values_seen,
  MIN(
    CASE
      WHEN level.rank_no > 1
        AND level.value - level.smaller_value
        > (extent.highest - extent.lowest) * CAST(1e-9 AS DOUBLE)
        THEN level.value - level.smaller_value
    END
  ) AS quantum
FROM distinct_values AS level
JOIN movements AS extent ON extent.channel_id = level.channel_id
GROUP BY level.channel_id
