-- Normalised: one sample in ranges of calibration, (x - lo) / (hi - lo), as for the grid of Phi (method,
-- section 3). Where the range is a point, x - lo: there is no other unit.
CASE
  WHEN scale.calibrated_hi > scale.calibrated_lo
    THEN (sampled.value - scale.calibrated_lo) / NULLIF(scale.calibrated_hi - scale.calibrated_lo, CAST(0 AS DOUBLE))
  ELSE sampled.value - scale.calibrated_lo
END
