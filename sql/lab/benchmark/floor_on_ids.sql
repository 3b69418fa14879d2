-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Floor on ids: as the floor on names, where someone has replaced the names by integers before.
SELECT SUM(summed) AS total
FROM (
  SELECT
    value
      + LAG(value, 1) OVER (PARTITION BY channel_id ORDER BY t)
      + LAG(value, 2) OVER (PARTITION BY channel_id ORDER BY t) AS summed
  FROM readings_by_id
) AS delayed
