-- Fleet metrics: prognosability (Eq. 8), discriminability (Eq. 9), and Global, the mean of those of the
-- five metrics that are available.
-- Reads:  fleet_parts, trendability
-- A row:  one drawing.
SELECT
  drawing,
  mon,
  mon_sd,
  mon_counted,
  corr_size,
  corr_sd,
  corr_counted,
  rob,
  rob_sd,
  rob_counted,
  prog,
  disc,
  trendability,
  amplitude,
  failed_counted,
  healthy_counted,
  (
    CASE WHEN mon IS NULL THEN CAST(0 AS DOUBLE) ELSE mon END
    + CASE WHEN corr_size IS NULL THEN CAST(0 AS DOUBLE) ELSE corr_size END
    + CASE WHEN rob IS NULL THEN CAST(0 AS DOUBLE) ELSE rob END
    + CASE WHEN prog IS NULL THEN CAST(0 AS DOUBLE) ELSE prog END
    + CASE WHEN disc IS NULL THEN CAST(0 AS DOUBLE) ELSE disc END
  ) / NULLIF(CAST(available AS DOUBLE), CAST(0 AS DOUBLE)) AS global_score,
  available
FROM (
  SELECT
    drawing,
    mon,
    mon_sd,
    mon_counted,
    corr_size,
    corr_sd,
    corr_counted,
    rob,
    rob_sd,
    rob_counted,
    prog,
    disc,
    trendability,
    amplitude,
    failed_counted,
    healthy_counted,
    CASE WHEN mon IS NULL THEN 0 ELSE 1 END
    + CASE WHEN corr_size IS NULL THEN 0 ELSE 1 END
    + CASE WHEN rob IS NULL THEN 0 ELSE 1 END
    + CASE WHEN prog IS NULL THEN 0 ELSE 1 END
    + CASE WHEN disc IS NULL THEN 0 ELSE 1 END AS available
  FROM (
    SELECT
      whole.drawing AS drawing,
      whole.mon AS mon,
      whole.mon_sd AS mon_sd,
      whole.mon_counted AS mon_counted,
      whole.corr_size AS corr_size,
      whole.corr_sd AS corr_sd,
      whole.corr_counted AS corr_counted,
      whole.rob AS rob,
      whole.rob_sd AS rob_sd,
      whole.rob_counted AS rob_counted,
      CASE
        WHEN whole.amplitude > CAST(0 AS DOUBLE) AND whole.failed_counted > 1
          THEN EXP(-(whole.last_sd / whole.amplitude))
      END AS prog,
      CASE
        WHEN whole.amplitude > CAST(0 AS DOUBLE)
          THEN CAST(1 AS DOUBLE) / (CAST(1 AS DOUBLE) + (whole.healthy_sd / whole.amplitude))
      END AS disc,
      CASE WHEN alike.hit = 1 THEN alike.trendability END AS trendability,
      whole.amplitude AS amplitude,
      whole.failed_counted AS failed_counted,
      whole.healthy_counted AS healthy_counted
    FROM fleet_parts AS whole
    LEFT JOIN (SELECT drawing, trendability, 1 AS hit FROM trendability) AS alike
      ON alike.drawing = whole.drawing
  ) AS formed
) AS counted
