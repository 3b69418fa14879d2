-- Place: where in the calibrated range a sample lies, in bins: bin = floor(place). In this order of operations
-- (Phi, method section 3); NULL where the range is one value.
-- Slots:  :bins
(value - lo) / NULLIF(hi - lo, CAST(0 AS DOUBLE)) * CAST(:bins AS DOUBLE)
