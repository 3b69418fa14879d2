-- Centre: the mean of the roots of some blocks (alarms, section 2).
-- Slots:  :least   the smallest root of the channel
--         :total   sum of root - least
--         :blocks  how many there are
:least + CAST(
  FLOOR(
    (CAST(:total AS DOUBLE) + CAST(5e-1 AS DOUBLE))
    / CAST(CASE WHEN :blocks > 0 THEN :blocks ELSE 1 END AS DOUBLE)
  ) AS BIGINT
)
