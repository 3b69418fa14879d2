-- Series metrics: monotonicity (Eq. 5), temporal correlation (Eq. 6) and robustness (Eq. 7) of each
-- series, with signs where they have one, and what the fleet's metrics need of it. What would be 0 / 0
-- is NULL.
-- Reads:  moments, residuals
-- A row:  one series.
-- Slots:  :monotonicity  its form, with its sign
--         :amplitude     its form
--         :ddof          what is taken from K under the standard deviation
SELECT
  series_id,
  k,
  first_hi,
  last_hi,
  lowest_hi,
  highest_hi,
  amplitude,
  hi_sd,
  mon_signed,
  ABS(mon_signed) AS mon,
  corr_signed,
  ABS(corr_signed) AS corr_size,
  CASE WHEN k >= 5 THEN EXP(-mean_distance) END AS rob
FROM (
  SELECT
    whole.series_id AS series_id,
    whole.k AS k,
    whole.first_hi AS first_hi,
    whole.last_hi AS last_hi,
    whole.lowest_hi AS lowest_hi,
    whole.highest_hi AS highest_hi,
    :amplitude AS amplitude,
    :monotonicity AS mon_signed,
    CAST(whole.level_time_sum AS DOUBLE)
    / NULLIF(
      SQRT(whole.level_variation * CAST(whole.time_square_sum AS DOUBLE)), CAST(0 AS DOUBLE)
    ) AS corr_signed,
    CASE
      WHEN whole.level_range > 0
        THEN SQRT(
          whole.level_variation / NULLIF(CAST(whole.k - :ddof AS DOUBLE), CAST(0 AS DOUBLE))
        ) / CAST(whole.level_range AS DOUBLE) * (whole.highest_hi - whole.lowest_hi)
      WHEN whole.k > :ddof THEN CAST(0 AS DOUBLE)
    END AS hi_sd,
    CASE WHEN residual.hit = 1 THEN residual.mean_distance END AS mean_distance
  FROM (
    SELECT
      series_id,
      k,
      rank_time_sum,
      rank_square_sum,
      time_square_sum,
      level_time_sum,
      level_range,
      rises_less_falls,
      first_hi,
      last_hi,
      lowest_hi,
      highest_hi,
      CAST(level_square_sum AS DOUBLE)
      - (CAST(level_sum AS DOUBLE) * CAST(level_sum AS DOUBLE) / CAST(k AS DOUBLE)) AS level_variation
    FROM moments
  ) AS whole
  LEFT JOIN (SELECT series_id, mean_distance, 1 AS hit FROM residuals) AS residual
    ON residual.series_id = whole.series_id
) AS measured
