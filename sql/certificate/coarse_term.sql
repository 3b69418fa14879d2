-- Coarse term: one coordinate of a stored cell, read off its key and put on the coarser grid. A code
-- of the support is 2 + bin; the key modulo R^(k+1), less the key modulo R^k, is code * R^k exactly,
-- so the quotient needs rounding only. Repeated by Python, once per coordinate, and summed.
-- Slots:  :weight  R^k, with R = bins + 3
--         :above   R^(k+1)
(
  2 + CAST(
    FLOOR(
      (
        FLOOR(
          CAST(cell_key % :above - cell_key % :weight AS DOUBLE) / CAST(:weight AS DOUBLE)
          + CAST(5e-1 AS DOUBLE)
        ) - CAST(2 AS DOUBLE)
      ) / divisor
    ) AS BIGINT
  )
) * CAST(:weight AS BIGINT)
