-- Channel summary: the metrics of each channel beside those of chance, and the reason of each that is
-- NULL. K values that each span a window hold K + (values per window) - 1 steps, and so many windows
-- that do not overlap.
-- Reads:  members, series_metrics, chance
-- A row:  one channel, in order.
SELECT
  asset,
  channel,
  outcome,
  CASE WHEN measured_k > 0 THEN measured_k ELSE 0 END AS k,
  CASE
    WHEN values_per_window > 0 AND measured_k > 0
      THEN CAST(
        FLOOR(
          CAST(measured_k + values_per_window - 1 AS DOUBLE) / CAST(values_per_window AS DOUBLE)
        ) AS BIGINT
      )
    WHEN values_per_window > 0 THEN 0
  END AS independent_windows,
  mon,
  mon_signed,
  corr_size,
  corr_signed,
  rob,
  CASE
    WHEN mon IS NOT NULL THEN NULL
    WHEN measured_k > 1 THEN 'constant'
    WHEN measured_k = 1 THEN 'one_value'
    ELSE 'no_values'
  END AS mon_reason,
  CASE
    WHEN corr_size IS NOT NULL THEN NULL
    WHEN measured_k > 1 THEN 'constant'
    WHEN measured_k = 1 THEN 'one_value'
    ELSE 'no_values'
  END AS corr_reason,
  CASE
    WHEN rob IS NOT NULL AND measured_k < 20 THEN 'interpolated'
    WHEN rob IS NOT NULL THEN NULL
    WHEN measured_k > 4 THEN 'constant'
    WHEN measured_k > 0 THEN 'short'
    ELSE 'no_values'
  END AS rob_reason,
  mon_chance,
  mon_chance_sd,
  corr_chance,
  corr_chance_sd,
  rob_chance,
  rob_chance_sd,
  chance_reason,
  first_hi,
  last_hi,
  amplitude,
  hi_sd
FROM (
  SELECT
    member.asset AS asset,
    member.channel AS channel,
    member.outcome AS outcome,
    member.values_per_window AS values_per_window,
    CASE WHEN measured.hit = 1 THEN measured.k END AS measured_k,
    CASE WHEN measured.hit = 1 THEN measured.mon END AS mon,
    CASE WHEN measured.hit = 1 THEN measured.mon_signed END AS mon_signed,
    CASE WHEN measured.hit = 1 THEN measured.corr_size END AS corr_size,
    CASE WHEN measured.hit = 1 THEN measured.corr_signed END AS corr_signed,
    CASE WHEN measured.hit = 1 THEN measured.rob END AS rob,
    CASE WHEN measured.hit = 1 THEN measured.first_hi END AS first_hi,
    CASE WHEN measured.hit = 1 THEN measured.last_hi END AS last_hi,
    CASE WHEN measured.hit = 1 THEN measured.amplitude END AS amplitude,
    CASE WHEN measured.hit = 1 THEN measured.hi_sd END AS hi_sd,
    CASE WHEN random.hit = 1 THEN random.mon_chance END AS mon_chance,
    CASE WHEN random.hit = 1 THEN random.mon_chance_sd END AS mon_chance_sd,
    CASE WHEN random.hit = 1 THEN random.corr_chance END AS corr_chance,
    CASE WHEN random.hit = 1 THEN random.corr_chance_sd END AS corr_chance_sd,
    CASE WHEN random.hit = 1 THEN random.rob_chance END AS rob_chance,
    CASE WHEN random.hit = 1 THEN random.rob_chance_sd END AS rob_chance_sd,
    CASE WHEN random.hit = 1 THEN random.chance_reason END AS chance_reason
  FROM members AS member
  LEFT JOIN (
    SELECT
      series_id,
      k,
      mon,
      mon_signed,
      corr_size,
      corr_signed,
      rob,
      first_hi,
      last_hi,
      amplitude,
      hi_sd,
      1 AS hit
    FROM series_metrics
  ) AS measured ON measured.series_id = member.series_id
  LEFT JOIN (
    SELECT
      series_id,
      mon_chance,
      mon_chance_sd,
      corr_chance,
      corr_chance_sd,
      rob_chance,
      rob_chance_sd,
      chance_reason,
      1 AS hit
    FROM chance
  ) AS random ON random.series_id = member.series_id
) AS joined
ORDER BY asset, channel
