-- Bin term: what one coordinate adds to the key of its cell, as in support/code.sql from a value that is
-- scaled already. Repeated by Python, once per coordinate, and summed.
-- Slots:  :coordinate
--         :bins
--         :weight  R^k, with R = bins + 3
CASE
  WHEN FLOOR(:coordinate * CAST(:bins AS DOUBLE)) >= CAST(:bins AS DOUBLE)
    THEN CAST(:bins + 1 AS BIGINT)
  ELSE 2 + CAST(FLOOR(:coordinate * CAST(:bins AS DOUBLE)) AS BIGINT)
END * CAST(:weight AS BIGINT)
