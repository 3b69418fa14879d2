-- Spread: the standard deviation of a further root, the centre being an estimate itself; at least half a root, for no
-- count is steadier than Poisson's (alarms, section 2).
-- Slots:  :total    sum of root - least
--         :squares  sum of its square
--         :blocks   how many roots there are
CASE
  WHEN SQRT(
    CAST(:blocks * :squares - :total * :total AS DOUBLE) * CAST(:blocks + 1 AS DOUBLE)
    / CAST(CASE WHEN :blocks > 1 THEN :blocks * :blocks * (:blocks - 1) ELSE 1 END AS DOUBLE)
  ) >= CAST(500 AS DOUBLE) THEN CAST(
    FLOOR(
      SQRT(
        CAST(:blocks * :squares - :total * :total AS DOUBLE) * CAST(:blocks + 1 AS DOUBLE)
        / CAST(CASE WHEN :blocks > 1 THEN :blocks * :blocks * (:blocks - 1) ELSE 1 END AS DOUBLE)
      )
    ) AS BIGINT
  )
  ELSE 500
END
