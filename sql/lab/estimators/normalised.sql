-- Normalised: one sample in ranges of calibration, (x - lo) / (hi - lo), as for the grid of Phi (method,
-- section 3). Where the range is a point, x - lo: there is no other unit.
CASE
  WHEN scale.hi > scale.lo
    THEN (sampled.value - scale.lo) / NULLIF(scale.hi - scale.lo, CAST(0 AS DOUBLE))
  ELSE sampled.value - scale.lo
END
