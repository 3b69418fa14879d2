-- Mixture scores: the negative log-likelihood, by log-sum-exp over the components: with the largest
-- exponent taken out the sum lies between 1 and their number, and is summed in integers of 2^-52.
-- Reads:  mixture_densities
-- A row:  one scored vector.
SELECT
  channel_id,
  time,
  -(
    peak + LN(
      CAST(
        SUM(
          CAST(
            FLOOR(
              EXP(
                CASE
                  WHEN log_density - peak < CAST(-7e2 AS DOUBLE) THEN CAST(-7e2 AS DOUBLE)
                  ELSE log_density - peak
                END
              ) * CAST(4503599627370496 AS DOUBLE) + CAST(5e-1 AS DOUBLE)
            ) AS BIGINT
          )
        ) AS DOUBLE
      ) / CAST(4503599627370496 AS DOUBLE)
    )
  ) AS score
FROM (
  SELECT
    channel_id,
    time,
    log_density,
    MAX(log_density) OVER (PARTITION BY channel_id, time) AS peak
  FROM mixture_densities
) AS peaked
GROUP BY channel_id, time, peak
