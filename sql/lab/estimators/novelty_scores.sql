-- Novelty scores: Discrete Support Estimation as one estimator among others: 1 where the cell of v(t) is
-- not in the support, else 0 (Eq. 4).
-- Reads:  novelty
-- A row:  one scored vector.
SELECT channel_id, time, CAST(novel AS DOUBLE) AS score
FROM novelty
