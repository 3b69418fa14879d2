-- Untaught: whether a vector of any sample may be scored: it is none of calibration, and its channel has
-- a range.
vector.calibration_vector = 0 AND scale.calibrated_lo IS NOT NULL
