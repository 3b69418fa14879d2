-- Trends: the Savitzky-Golay trend of order 2 at each value (Eq. 7), as the fit of the three orthogonal
-- polynomials 1, j and 3 j^2 - h (h + 1) to the window, whose squared norms are 2h + 1,
-- h (h + 1) (2h + 1) / 3 and h (h + 1) (2h - 1) (2h + 1) (2h + 3) / 5. In the middle j = 0; towards the
-- ends the fit to the first or last full window is read off beside its centre (SciPy's "interp").
-- Reads:  windows
-- A row:  one value; a window of one value is its own trend.
SELECT
  series_id,
  value_no,
  k,
  level_deviation,
  CASE
    WHEN h = 0 THEN CAST(level_deviation AS DOUBLE)
    ELSE
      CAST(moment_0 AS DOUBLE) / CAST(2 * h + 1 AS DOUBLE)
      + (
        CAST(j AS DOUBLE)
        * (CAST(3 * moment_1 AS DOUBLE) / NULLIF(CAST(h * (h + 1) * (2 * h + 1) AS DOUBLE), CAST(0 AS DOUBLE)))
      )
      + (
        CAST(3 * j * j - h * (h + 1) AS DOUBLE)
        * (
          (CAST(5 * moment_2 AS DOUBLE) / NULLIF(CAST(h * (h + 1) * (2 * h + 1) AS DOUBLE), CAST(0 AS DOUBLE)))
          / CAST((2 * h - 1) * (2 * h + 3) AS DOUBLE)
        )
      )
  END AS trend
FROM windows
