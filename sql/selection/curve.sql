-- Curve: mutual information and autocorrelation by lag, and whether the information is more than chance.
-- Twice the pairs times I is about chi-square under independence, with d = (K_x - 1) (K_y - 1) degrees
-- of freedom; it exceeds d + 2 sqrt(10 d) + 20 once in e^10 (Laurent and Massart 2000, Lemma 1).
-- Reads:  information, autocorrelation, extents
-- A row:  one lag of one channel, lag 0 included; ami_corrected is by Miller and Madow:
--         I - (K_xy - K_x - K_y + 1) / (2 n_pairs).
SELECT
  channel_id,
  delay,
  n_pairs,
  occupied,
  ami,
  ami
  - CAST(occupied - now_bins - then_bins + 1 AS DOUBLE) / (CAST(2 AS DOUBLE) * CAST(n_pairs AS DOUBLE))
    AS ami_corrected,
  acf,
  CASE
    WHEN CAST(2 AS DOUBLE) * CAST(n_pairs AS DOUBLE) * ami
      > freedom + CAST(2 AS DOUBLE) * SQRT(CAST(10 AS DOUBLE) * freedom) + CAST(20 AS DOUBLE) THEN 1
    ELSE 0
  END AS informative
FROM (
  SELECT
    shared.channel_id AS channel_id,
    shared.delay AS delay,
    shared.n_pairs AS n_pairs,
    shared.occupied AS occupied,
    shared.now_bins AS now_bins,
    shared.then_bins AS then_bins,
    CAST(shared.units AS DOUBLE) / CAST(16777216 AS DOUBLE) / CAST(shared.n_pairs AS DOUBLE) AS ami,
    CAST((shared.now_bins - 1) * (shared.then_bins - 1) AS DOUBLE) AS freedom,
    echo.acf AS acf
  FROM information AS shared
  JOIN extents AS extent ON extent.channel_id = shared.channel_id
  JOIN autocorrelation AS echo
    ON echo.channel_id = shared.channel_id AND echo.delay = shared.delay
  WHERE echo.scale = 1 AND shared.delay <= extent.longest_lag
) AS joined
