-- Pool spread: by which floor and highest block a support is told what it would show: where members taught nothing, and
-- several did, by those of whole machines (both sides, section 6).
-- Reads:  spread, vouching, bounds, member_sizes
-- A row:  one support.
SELECT
  whole.support_id AS support_id,
  CASE WHEN silent.hit = 1 THEN silent.floor ELSE whole.floor END AS floor,
  CASE WHEN silent.hit = 1 THEN silent.floor_max ELSE whole.floor_max END AS floor_max
FROM spread AS whole
LEFT JOIN (
  SELECT says.support_id AS support_id, MIN(says.floor) AS floor, MIN(says.floor_max) AS floor_max, 1 AS hit
  FROM vouching AS says
  JOIN bounds AS scale ON scale.support_id = says.support_id
  LEFT JOIN (
    SELECT channel_id, 1 AS hit
    FROM member_sizes
  ) AS taught ON taught.channel_id = scale.channel_id
  WHERE CASE WHEN taught.hit = 1 THEN 1 ELSE 0 END < 1 AND says.teachers > 1
  GROUP BY says.support_id
) AS silent ON silent.support_id = whole.support_id
