-- Is picked: whether the calibration vector of a number is one of those by which its support is probed.
-- Slots:  none; number counts from 0, vectors is how many the support has
CAST((number * 1640531527) % 4294967296 AS DOUBLE) < FLOOR(
  CAST(4294967296 AS DOUBLE) / (
    FLOOR((CAST(vectors AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(1000 AS DOUBLE)) + CAST(1 AS DOUBLE)
  )
)
