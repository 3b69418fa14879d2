-- Unmoved: one sample of a vector as it would be without a move. Repeated by Python, once per coordinate. A sample
-- so large that the quotient might leave the range of doubles is NULL; one so small is 0.
-- Slots:  :value  the sample
CASE
  WHEN ABS(:value) > CAST(1e200 AS DOUBLE) THEN NULL
  WHEN ABS(:value - move.displacement) < CAST(1e-200 AS DOUBLE) THEN CAST(0 AS DOUBLE)
  ELSE (:value - move.displacement) / move.factor
END
