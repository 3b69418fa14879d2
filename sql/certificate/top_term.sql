-- Top term: as coarse_term, for the oldest coordinate, whose R^m need not fit in 64 bits with a sign.
-- Slots:  :weight  R^(m-1), with R = bins + 3
(
  2 + CAST(
    FLOOR(
      (
        FLOOR(
          CAST(cell_key - cell_key % :weight AS DOUBLE) / CAST(:weight AS DOUBLE)
          + CAST(5e-1 AS DOUBLE)
        ) - CAST(2 AS DOUBLE)
      ) / divisor
    ) AS BIGINT
  )
) * CAST(:weight AS BIGINT)
