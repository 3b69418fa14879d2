-- Counted: whether a vector counts: no sample is missing, and its newest one is to be scored.
vector.cell_key IS NOT NULL AND vector.time >= scale.first_scored
