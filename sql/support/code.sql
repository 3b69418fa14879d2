-- Code: the integer code of one sample (Phi, method section 3): 0 missing, 1 below the calibrated
-- range (or where there is no range), 2 + bin inside it, bins + 2 above it. What lies above the range has a place of
-- bins or more, as x = hi has, and whatever comes to bins by rounding; these two belong to the last bin. The usual case comes first.
-- Slots:  :bins
--         :place  the expression of support/place.sql, or a column that holds it
CASE
  WHEN value >= lo AND :place < CAST(:bins AS DOUBLE) THEN 2 + FLOOR(:place)
  WHEN value IS NULL THEN 0
  WHEN lo IS NULL OR value < lo THEN 1
  WHEN value > hi THEN :bins + 2
  WHEN hi = lo THEN 2
  ELSE :bins + 1
END
