-- Moments: the integer sums that monotonicity (Eq. 5) and temporal correlation (Eq. 6) are made of, the
-- first and last value, the lowest and highest.
-- Reads:  centred
-- A row:  one series.
SELECT
  series_id,
  MAX(value.k) AS k,
  CAST(SUM(rank_deviation * time_deviation) AS BIGINT) AS rank_time_sum,
  CAST(SUM(rank_deviation * rank_deviation) AS BIGINT) AS rank_square_sum,
  CAST(SUM(time_deviation * time_deviation) AS BIGINT) AS time_square_sum,
  CAST(SUM(level_deviation * time_deviation) AS BIGINT) AS level_time_sum,
  CAST(SUM(level_deviation * level_deviation) AS BIGINT) AS level_square_sum,
  CAST(SUM(level_deviation) AS BIGINT) AS level_sum,
  MAX(level_deviation) - MIN(level_deviation) AS level_range,
  CAST(
    SUM(
      CASE
        WHEN value_no > 1 AND hi > hi_before THEN 1
        WHEN value_no > 1 AND hi < hi_before THEN -1
        ELSE 0
      END
    ) AS BIGINT
  ) AS rises_less_falls,
  MAX(CASE WHEN value_no = 1 THEN hi END) AS first_hi,
  MAX(CASE WHEN value_no = value.k THEN hi END) AS last_hi,
  MIN(hi) AS lowest_hi,
  MAX(hi) AS highest_hi
FROM centred AS value
GROUP BY series_id
