-- Nearest: which vectors are the neighbours, by the Euclidean distance and by the maximum norm. Of
-- several at one distance it is the earliest of those before the Theiler window, or where there is none
-- the latest after it.
-- Reads:  measured, rounds
-- A row:  one reference vector that this round settled.
SELECT
  channel_id,
  place,
  square,
  largest,
  twin,
  CASE WHEN early_square IS NOT NULL THEN early_square ELSE late_square END AS square_place,
  CASE WHEN early_largest IS NOT NULL THEN early_largest ELSE late_largest END AS largest_place
FROM (
  SELECT
    pair.channel_id AS channel_id,
    pair.place AS place,
    MIN(reached.square) AS square,
    MIN(reached.largest) AS largest,
    MAX(reached.twin) AS twin,
    MIN(
      CASE
        WHEN pair.square = reached.square AND pair.first_place < pair.place - pair.nearby
          THEN pair.first_place
      END
    ) AS early_square,
    MAX(
      CASE
        WHEN pair.square = reached.square AND pair.last_place > pair.place + pair.nearby
          THEN pair.last_place
      END
    ) AS late_square,
    MIN(
      CASE
        WHEN pair.largest = reached.largest AND pair.first_place < pair.place - pair.nearby
          THEN pair.first_place
      END
    ) AS early_largest,
    MAX(
      CASE
        WHEN pair.largest = reached.largest AND pair.last_place > pair.place + pair.nearby
          THEN pair.last_place
      END
    ) AS late_largest
  FROM measured AS pair
  JOIN rounds AS reached ON reached.channel_id = pair.channel_id AND reached.place = pair.place
  WHERE reached.settled = 1
    AND (pair.square = reached.square OR pair.largest = reached.largest)
  GROUP BY pair.channel_id, pair.place
) AS nearest_pair
