-- Straddling: whether a vector that is scored reaches back into calibration, where that is all there is before (method,
-- section 4).
vector.oldest_time < scale.first_scored
