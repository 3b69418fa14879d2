-- Nearest: which vector is the neighbour. Of several at one distance it is the earliest of those before
-- the Theiler window, or where there is none the latest after it.
-- Reads:  measured, rounds
-- A row:  one reference vector that this round settled.
SELECT
  pair.channel_id AS channel_id,
  pair.place AS place,
  CASE
    WHEN MIN(pair.early_place) IS NOT NULL THEN MIN(pair.early_place)
    ELSE MAX(pair.late_place)
  END AS neighbour,
  MIN(pair.distance) AS distance,
  MAX(reached.twin) AS twin
FROM measured AS pair
JOIN rounds AS reached ON reached.channel_id = pair.channel_id AND reached.place = pair.place
WHERE reached.settled = 1 AND pair.distance = reached.nearest
GROUP BY pair.channel_id, pair.place
