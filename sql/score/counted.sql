-- Counted: whether a vector is to be scored: no sample is missing, and its newest one comes after calibration (or is
-- from score_from on).
vector.cell_key IS NOT NULL AND vector.time >= scale.first_scored
