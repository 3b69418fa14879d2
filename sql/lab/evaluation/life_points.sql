-- Life points: failed series at equal shares of their lives, so that lives of any length compare: the
-- value whose number is nearest to 1 + share * (K - 1).
-- Reads:  centred, moments, members, life_shares
-- A row:  one point of one failed series; the level is taken from its mean over the points, rounded.
SELECT
  series_id,
  asset_no,
  point_no,
  points,
  level_deviation
  - CAST(FLOOR(CAST(level_sum AS DOUBLE) / CAST(points AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT)
    AS level
FROM (
  SELECT
    wanted.series_id AS series_id,
    wanted.asset_no AS asset_no,
    wanted.point_no AS point_no,
    value.level_deviation AS level_deviation,
    CAST(COUNT(*) OVER (PARTITION BY wanted.series_id) AS BIGINT) AS points,
    CAST(SUM(value.level_deviation) OVER (PARTITION BY wanted.series_id) AS BIGINT) AS level_sum
  FROM (
    SELECT
      lived.series_id AS series_id,
      lived.asset_no AS asset_no,
      share.point_no AS point_no,
      1 + CAST(
        FLOOR(
          CAST((lived.k - 1) * share.point_no AS DOUBLE) / CAST(share.last_point AS DOUBLE)
          + CAST(5e-1 AS DOUBLE)
        ) AS BIGINT
      ) AS value_no
    FROM (
      SELECT member.series_id AS series_id, member.asset_no AS asset_no, whole.k AS k
      FROM members AS member
      JOIN moments AS whole ON whole.series_id = member.series_id
      WHERE member.stratum = 0 AND member.has_outcome = 1 AND whole.k > 1
    ) AS lived
    CROSS JOIN life_shares AS share
  ) AS wanted
  JOIN centred AS value
    ON value.series_id = wanted.series_id AND value.value_no = wanted.value_no
) AS summed
