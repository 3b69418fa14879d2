-- Cao: E1(d) = E(d+1) / E(d), which stops growing where the attractor is unfolded, and E2(d) =
-- E*(d+1) / E*(d), which is near 1 for every d where the future does not depend on the past.
-- Reads:  expansions
-- A row:  one dimension of one channel; e1_next is E1(d+1).
-- Slots:  :m_max  the largest dimension
SELECT channel_id, m, e1, e2, e1_next
FROM (
  SELECT
    channel_id,
    m,
    e1,
    e2,
    CASE
      WHEN m < :m_max THEN LAG(e1, 1) OVER (PARTITION BY channel_id ORDER BY m DESC)
    END AS e1_next
  FROM (
    SELECT
      channel_id,
      m,
      CAST(
        ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY m DESC) AS BIGINT
      ) AS from_last,
      LAG(growth, 1) OVER (PARTITION BY channel_id ORDER BY m DESC)
      / NULLIF(growth, CAST(0 AS DOUBLE)) AS e1,
      LAG(mean_parting, 1) OVER (PARTITION BY channel_id ORDER BY m DESC)
      / NULLIF(mean_parting, CAST(0 AS DOUBLE)) AS e2
    FROM expansions
  ) AS ratios
  WHERE from_last > 1
) AS followed_up
