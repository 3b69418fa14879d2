-- Move counts: of how many vectors that are read again each move explains the novelty: without it they are in the support.
-- Reads:  moved, support, cohort
-- A row:  one move of one window; regained counts the novel vectors that it explains, lost the others that would be
--         novel without it. Of move 0, none, both are 0.
SELECT
  member.version_id AS version_id,
  counted.window_no AS window_no,
  counted.move_no AS move_no,
  counted.factor AS factor,
  counted.displacement AS displacement,
  counted.vectors AS vectors,
  counted.novel AS novel,
  counted.regained AS regained,
  counted.lost AS lost
FROM (
  SELECT
    vector.channel_id AS channel_id,
    vector.window_no AS window_no,
    vector.move_no AS move_no,
    MIN(vector.factor) AS factor,
    MIN(vector.displacement) AS displacement,
    CAST(COUNT(*) AS BIGINT) AS vectors,
    CAST(SUM(vector.novel) AS BIGINT) AS novel,
    CAST(
      SUM(CASE WHEN vector.move_no > 0 AND vector.novel = 1 AND healthy.hit = 1 THEN 1 ELSE 0 END) AS BIGINT
    ) AS regained,
    CAST(
      SUM(
        CASE WHEN vector.move_no = 0 OR vector.novel = 1 THEN 0 WHEN healthy.hit = 1 THEN 0 ELSE 1 END
      ) AS BIGINT
    ) AS lost
  FROM moved AS vector
  LEFT JOIN (
    SELECT support_id, cell_key, 1 AS hit
    FROM support
  ) AS healthy ON healthy.support_id = vector.support_id AND healthy.cell_key = vector.cell_key
  GROUP BY vector.channel_id, vector.window_no, vector.move_no
) AS counted
JOIN cohort AS member ON member.channel_id = counted.channel_id
