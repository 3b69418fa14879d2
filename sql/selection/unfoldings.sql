-- Unfoldings: m by each rule. False neighbours: the first dimension with at most 1 % of them that exact
-- repetitions do not say to be too small, or
-- noise_floor where none has: a jumping or noisy series has neighbours that part, in every dimension.
-- Cao: the first with E1 >= 0.9 that changes by at most 0.05 to the next; stochastic where every E2 is
-- within 0.1 of 1.
-- Reads:  dimensions
-- A row:  one channel that has reference vectors.
SELECT
  channel_id,
  m_fnn,
  CASE
    WHEN m_fnn IS NOT NULL THEN 'fnn'
    WHEN tried > 0 THEN 'noise_floor'
    ELSE 'none'
  END AS fnn_status,
  m_cao,
  CASE
    WHEN compared = 0 THEN 'none'
    WHEN apart = 0 THEN 'stochastic'
    WHEN m_cao IS NOT NULL THEN 'saturated'
    ELSE 'no_saturation'
  END AS cao_status
FROM (
  SELECT
    channel_id,
    MIN(
      CASE
        WHEN neighbours > 0 AND 100 * false_neighbours <= neighbours AND is_ambiguous = 0 THEN m
      END
    ) AS m_fnn,
    CAST(SUM(CASE WHEN neighbours > 0 THEN 1 ELSE 0 END) AS BIGINT) AS tried,
    MIN(
      CASE
        WHEN e1 >= CAST(9e-1 AS DOUBLE) AND ABS(e1_next - e1) <= CAST(5e-2 AS DOUBLE) THEN m
      END
    ) AS m_cao,
    CAST(SUM(CASE WHEN e2 >= CAST(0 AS DOUBLE) THEN 1 ELSE 0 END) AS BIGINT) AS compared,
    CAST(
      SUM(CASE WHEN ABS(e2 - CAST(1 AS DOUBLE)) >= CAST(1e-1 AS DOUBLE) THEN 1 ELSE 0 END) AS BIGINT
    ) AS apart
  FROM dimensions
  GROUP BY channel_id
) AS judged
