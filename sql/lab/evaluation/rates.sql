-- Rates: how many values a series has, and the novel vectors of their windows: what surrogates are to
-- have in common with it.
-- Reads:  selected
-- A row:  one series.
SELECT
  series_id,
  CAST(COUNT(*) AS BIGINT) AS k,
  CAST(SUM(novel_in_window) AS BIGINT) AS novel_sum
FROM selected
GROUP BY series_id
