-- Code: the integer code of one sample (Phi, method section 3): 0 missing, 1 below the calibrated
-- range (or where there is no range), 2 + bin inside it, bins + 2 above it. bin = floor((x - lo) / (hi - lo) * bins), in this
-- order of operations; x = hi, or a result of bins by rounding, belongs to the last bin.
-- Slots:  :bins
CASE
  WHEN value IS NULL THEN 0
  WHEN lo IS NULL OR value < lo THEN 1
  WHEN value > hi THEN :bins + 2
  WHEN hi = lo THEN 2
  WHEN FLOOR((value - lo) / NULLIF(hi - lo, CAST(0 AS DOUBLE)) * CAST(:bins AS DOUBLE))
    >= CAST(:bins AS DOUBLE) THEN :bins + 1
  ELSE 2 + FLOOR((value - lo) / NULLIF(hi - lo, CAST(0 AS DOUBLE)) * CAST(:bins AS DOUBLE))
END
