-- Usual: between which values a signal usually lies: the newest values of picked vectors in order, of which one in
-- twenty lies below q05 and one above q95; q50 is in the middle.
-- Reads:  probed, bounds
-- A row:  one support; width is that of its range where q05 and q95 are equal.
SELECT
  support_id,
  q05,
  q50,
  q95,
  CASE WHEN q95 > q05 THEN q95 - q05 ELSE hi - lo END AS width,
  lo,
  hi
FROM (
  SELECT
    ranked.support_id AS support_id,
    MAX(
      CASE
        WHEN ranked.place = FLOOR(
          (CAST(ranked.vectors + 19 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(20 AS DOUBLE)
        )
          THEN ranked.value
      END
    ) AS q05,
    MAX(
      CASE
        WHEN ranked.place = FLOOR(
          (CAST(ranked.vectors + 1 AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(2 AS DOUBLE)
        )
          THEN ranked.value
      END
    ) AS q50,
    MAX(
      CASE
        WHEN ranked.vectors - ranked.place = FLOOR(
          (CAST(ranked.vectors AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(20 AS DOUBLE)
        )
          THEN ranked.value
      END
    ) AS q95,
    MIN(scale.calibrated_lo) AS lo,
    MAX(scale.calibrated_hi) AS hi
  FROM (
    SELECT
      support_id,
      x_0 AS value,
      CAST(COUNT(*) OVER (PARTITION BY support_id) AS BIGINT) AS vectors,
      CAST(ROW_NUMBER() OVER (PARTITION BY support_id ORDER BY x_0) AS BIGINT) AS place
    FROM probed
  ) AS ranked
  JOIN bounds AS scale ON scale.channel_id = ranked.support_id
  GROUP BY ranked.support_id
) AS measured
