-- Ordered: the K values of a series in order, numbered from 1, beside their extremes.
-- Reads:  selected
-- A row:  one value.
SELECT
  series_id,
  steps,
  hi,
  novel_in_window,
  CAST(ROW_NUMBER() OVER (PARTITION BY series_id ORDER BY place) AS BIGINT) AS value_no,
  LAG(hi, 1) OVER (PARTITION BY series_id ORDER BY place) AS hi_before,
  CAST(COUNT(*) OVER (PARTITION BY series_id) AS BIGINT) AS k,
  MIN(hi) OVER (PARTITION BY series_id) AS lowest_hi,
  MAX(hi) OVER (PARTITION BY series_id) AS highest_hi,
  MIN(novel_in_window) OVER (PARTITION BY series_id) AS lowest_count
FROM selected
