-- Residuals: the mean distance of the values from their trend, in amplitudes. Each distance is counted
-- in whole units of a share of 2^-59 * K, so that sums are sums of integers (no distance exceeds four
-- amplitudes).
-- Reads:  trends, moments
-- A row:  one series that is not constant.
SELECT
  distances.series_id AS series_id,
  CAST(CAST(SUM(distances.distance_units) AS BIGINT) AS DOUBLE) / MAX(distances.units)
  / CAST(MAX(distances.k) AS DOUBLE) AS mean_distance
FROM (
  SELECT
    series_id,
    k,
    units,
    CAST(FLOOR(distance * units + CAST(5e-1 AS DOUBLE)) AS BIGINT) AS distance_units
  FROM (
    SELECT
      fitted.series_id AS series_id,
      fitted.k AS k,
      FLOOR(CAST(576460752303423488 AS DOUBLE) / CAST(fitted.k AS DOUBLE)) AS units,
      ABS(CAST(fitted.level_deviation AS DOUBLE) - fitted.trend) / CAST(whole.level_range AS DOUBLE)
        AS distance
    FROM trends AS fitted
    JOIN moments AS whole ON whole.series_id = fitted.series_id
    WHERE whole.level_range > 0
  ) AS shares
) AS distances
GROUP BY distances.series_id
