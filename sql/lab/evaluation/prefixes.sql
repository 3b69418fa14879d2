-- Prefixes: running sums of the level and of its products with place and place squared, from which the
-- sums over any window are differences; and the window of the Savitzky-Golay trend around each value:
-- half width K / 10, rounded down; at both ends the first or last full window. value_key tells values of
-- all series apart by one number: joined by two columns, a planner may pair all values of a series first.
-- Reads:  centred
-- A row:  one value.
SELECT
  series_id,
  value_no,
  k,
  half_width,
  place,
  level_deviation,
  series_id * 4194304 + value_no AS value_key,
  CASE
    WHEN value_no <= half_width THEN half_width + 1
    WHEN value_no > k - half_width THEN k - half_width
    ELSE value_no
  END AS centre_no,
  CAST(
    SUM(level_deviation) OVER (
      PARTITION BY series_id ORDER BY value_no ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) AS sum_0,
  CAST(
    SUM(place * level_deviation) OVER (
      PARTITION BY series_id ORDER BY value_no ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) AS sum_1,
  CAST(
    SUM(place * place * level_deviation) OVER (
      PARTITION BY series_id ORDER BY value_no ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) AS sum_2
FROM (
  SELECT
    series_id,
    value_no,
    k,
    place,
    level_deviation,
    CAST(
      FLOOR((CAST(k AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(10 AS DOUBLE)) AS BIGINT
    ) AS half_width
  FROM centred
) AS ordered
