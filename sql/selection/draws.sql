-- Draws: the vectors that some dimension may draw as a reference; all, where the largest has too few.
-- Reads:  scattered, deepest
-- A row:  one vector.
-- Slots:  :carried     u_0, u_1 and so on
--         :references  how many are drawn
SELECT channel_id, place, tau, memory, depth, scattered, :carried
FROM (
  SELECT
    vector.channel_id AS channel_id,
    vector.place AS place,
    vector.tau AS tau,
    vector.memory AS memory,
    vector.depth AS depth,
    vector.scattered AS scattered,
    :carried,
    CASE
      WHEN bound.hit = 1 AND bound.drawn >= :references AND vector.scattered > bound.last_drawn
        THEN 1
      ELSE 0
    END AS late
  FROM scattered AS vector
  LEFT JOIN (
    SELECT channel_id, last_drawn, drawn, 1 AS hit
    FROM deepest
  ) AS bound ON bound.channel_id = vector.channel_id
) AS judged
WHERE late = 0
