-- Bin term: what one coordinate adds to the key of its cell, as in support/code.sql from a value that is
-- scaled already. Repeated by Python, once per coordinate, and summed.
-- Slots:  :coordinate
--         :bins
--         :weight  R^k, with R = bins + 3
(
  2 + CAST(
    CASE
      WHEN FLOOR(:coordinate * CAST(:bins AS DOUBLE)) >= CAST(:bins AS DOUBLE)
        THEN CAST(:bins AS DOUBLE) - CAST(1 AS DOUBLE)
      ELSE FLOOR(:coordinate * CAST(:bins AS DOUBLE))
    END AS BIGINT
  )
) * CAST(:weight AS BIGINT)
