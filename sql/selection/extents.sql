-- Extents: how much there is to choose from. Lags are looked at up to a tenth of the samples.
-- Reads:  selected
-- A row:  one channel; usable samples are neither missing nor of a constant channel; mean is that of
--         scaled, from integers in units of 2^-30.
-- Slots:  :tau_max  the largest lag
SELECT
  channel_id,
  samples,
  usable,
  CASE
    WHEN FLOOR((CAST(samples AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(10 AS DOUBLE))
      < CAST(:tau_max AS DOUBLE)
      THEN CAST(
        FLOOR((CAST(samples AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(10 AS DOUBLE)) AS BIGINT
      )
    ELSE CAST(:tau_max AS BIGINT)
  END AS longest_lag,
  CAST(scaled_units AS DOUBLE) / CAST(1073741824 AS DOUBLE)
  / NULLIF(CAST(usable AS DOUBLE), CAST(0 AS DOUBLE)) AS mean
FROM (
  SELECT
    channel_id,
    CAST(COUNT(*) AS BIGINT) AS samples,
    CAST(SUM(CASE WHEN scaled >= CAST(0 AS DOUBLE) THEN 1 ELSE 0 END) AS BIGINT) AS usable,
    CAST(
      SUM(
        CAST(FLOOR(scaled * CAST(1073741824 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT)
      ) AS BIGINT
    ) AS scaled_units
  FROM selected
  GROUP BY channel_id
) AS counted
