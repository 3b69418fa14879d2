-- Autocorrelation: the correlation of the pairs of each lag, both sides about their own means.
-- Reads:  echoes
-- A row:  one lag of one scale of one channel; acf is NULL where one side does not vary.
SELECT
  channel_id,
  scale,
  delay,
  n_pairs,
  (CAST(n_pairs AS DOUBLE) * CAST(products AS DOUBLE)
    - CAST(now_sum AS DOUBLE) * CAST(then_sum AS DOUBLE))
  / NULLIF(
    SQRT(
      CAST(n_pairs AS DOUBLE) * CAST(now_squares AS DOUBLE)
      - CAST(now_sum AS DOUBLE) * CAST(now_sum AS DOUBLE)
    ) * SQRT(
      CAST(n_pairs AS DOUBLE) * CAST(then_squares AS DOUBLE)
      - CAST(then_sum AS DOUBLE) * CAST(then_sum AS DOUBLE)
    ),
    CAST(0 AS DOUBLE)
  ) AS acf
FROM echoes
