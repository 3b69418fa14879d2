-- Centred: ranks, times and levels about their means, as exact integers. With ties averaged, twice the
-- rank is 2 * RANK + ties - 1; rank_deviation and time_deviation are twice the deviation from the mean
-- rank (K + 1) / 2, and add up to 0. Levels are taken from their mean, rounded, and place from the
-- middle, so that sums over them stay small.
-- Reads:  levels
-- A row:  one value.
SELECT
  series_id,
  value_no,
  k,
  hi,
  hi_before,
  level - CAST(FLOOR(CAST(level_sum AS DOUBLE) / CAST(k AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT)
    AS level_deviation,
  2 * hi_rank + ties - 1 - (k + 1) AS rank_deviation,
  2 * value_no - (k + 1) AS time_deviation,
  value_no - CAST(FLOOR(CAST(k AS DOUBLE) / CAST(2 AS DOUBLE)) AS BIGINT) AS place
FROM (
  SELECT
    series_id,
    value_no,
    k,
    hi,
    hi_before,
    level,
    CAST(SUM(level) OVER (PARTITION BY series_id) AS BIGINT) AS level_sum,
    CAST(RANK() OVER (PARTITION BY series_id ORDER BY hi) AS BIGINT) AS hi_rank,
    CAST(COUNT(*) OVER (PARTITION BY series_id, hi) AS BIGINT) AS ties
  FROM levels
) AS ranked
