-- Measured level: an indicator that is no count, as an integer: the nearest of equal steps from the
-- lowest value of its series to the highest.
CASE
  WHEN highest_hi > lowest_hi
    THEN CAST(
      FLOOR(
        (hi - lowest_hi) / (highest_hi - lowest_hi) * CAST(steps AS DOUBLE) + CAST(5e-1 AS DOUBLE)
      ) AS BIGINT
    )
  ELSE 0
END
