-- Joint: m and B together, for the calibration there is. Of the dimensions up to the one that unfolds the
-- attractor, the largest whose finest passing grid still has 10 bins; else the one with the finest
-- passing grid; else the dimension that was wanted, which needs more data.
-- Reads:  budget, unfoldings
-- A row:  one channel that has vectors.
-- Slots:  :m  the dimension wanted where no rule finds one
SELECT
  channel_id,
  wanted_m,
  m,
  vectors,
  verdict,
  finest_bins,
  finest_floor,
  floor,
  vectors_needed
FROM (
  SELECT
    channel_id,
    wanted_m,
    m,
    vectors,
    verdict,
    finest_bins,
    finest_floor,
    floor,
    vectors_needed,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY channel_id
        ORDER BY
          grade DESC,
          CASE WHEN grade = 1 THEN finest_bins ELSE 0 END DESC,
          m DESC
      ) AS BIGINT
    ) AS turn
  FROM (
    SELECT
      affordable.channel_id AS channel_id,
      wish.wanted_m AS wanted_m,
      affordable.m AS m,
      affordable.vectors AS vectors,
      affordable.verdict AS verdict,
      affordable.finest_bins AS finest_bins,
      affordable.finest_floor AS finest_floor,
      affordable.floor AS floor,
      affordable.vectors_needed AS vectors_needed,
      CASE
        WHEN affordable.finest_bins >= 10 OR affordable.verdict = 'ready' THEN 2
        WHEN affordable.finest_bins >= 1 THEN 1
        ELSE 0
      END AS grade
    FROM budget AS affordable
    JOIN (
      SELECT
        channel_id,
        CASE
          WHEN m_fnn IS NOT NULL THEN m_fnn
          WHEN m_cao IS NOT NULL AND cao_status = 'saturated' THEN m_cao
          ELSE CAST(:m AS INTEGER)
        END AS wanted_m
      FROM unfoldings
    ) AS wish ON wish.channel_id = affordable.channel_id
    WHERE affordable.m <= wish.wanted_m
  ) AS graded
) AS ranked
WHERE turn = 1
