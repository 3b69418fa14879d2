-- Band: which twentieth of the calibrated range the newest coordinate of a cell lies in (alarms, section 5): -1 below
-- the range, 0, 1, ... in it, the number of bands above it. A grid of fewer than 20 bins has a band for each. A vector
-- with a missing sample has no cell, and so no band.
-- Slots:  :key   the cell
--         :bins  B of its version
CASE
  WHEN :key % (:bins + 3) = 1 THEN -1
  WHEN :key % (:bins + 3) = :bins + 2 THEN CASE WHEN :bins < 20 THEN :bins ELSE 20 END
  ELSE CAST(
    FLOOR(
      (CAST((:key % (:bins + 3) - 2) * CASE WHEN :bins < 20 THEN :bins ELSE 20 END AS DOUBLE) + CAST(5e-1 AS DOUBLE))
      / CAST(:bins AS DOUBLE)
    ) AS BIGINT
  )
END
