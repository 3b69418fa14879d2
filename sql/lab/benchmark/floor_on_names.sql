-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Floor on names: the least that an engine must do for a delay vector of three, on the raw table:
-- sort every channel by time and look back twice.
SELECT SUM(summed) AS total
FROM (
  SELECT
    value
      + LAG(value, 1) OVER (PARTITION BY asset, channel ORDER BY t)
      + LAG(value, 2) OVER (PARTITION BY asset, channel ORDER BY t) AS summed
  FROM readings
) AS delayed
