-- Bin code: the code of a sample, as in support/code.sql from a value that is scaled already.
-- Slots:  :bins
CAST(
  CASE
    WHEN FLOOR(taken.scaled * CAST(:bins AS DOUBLE)) >= CAST(:bins AS DOUBLE) THEN :bins + 1
    ELSE 2 + FLOOR(taken.scaled * CAST(:bins AS DOUBLE))
  END AS INTEGER
)
