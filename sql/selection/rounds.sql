-- Rounds: the smallest distances above zero in the boxes of this size. They are the smallest of all if
-- the Euclidean one is smaller than a box: what lies outside the boxes searched is further away than
-- that. Else the next round searches larger ones. Zero distances are skipped, and marked.
-- Reads:  unsettled, measured
-- A row:  one reference vector that had no neighbour before this round.
-- Slots:  :reach  the squared distance below which it is settled
SELECT
  channel_id,
  place,
  square,
  largest,
  twin,
  CASE WHEN square < CAST(:reach AS BIGINT) THEN 1 ELSE 0 END AS settled
FROM (
  SELECT
    waiting.channel_id AS channel_id,
    waiting.place AS place,
    CASE WHEN seen.hit = 1 THEN seen.square END AS square,
    CASE WHEN seen.hit = 1 THEN seen.largest END AS largest,
    CASE WHEN seen.hit = 1 THEN seen.twin ELSE 0 END AS twin
  FROM unsettled AS waiting
  LEFT JOIN (
    SELECT
      channel_id,
      place,
      MIN(CASE WHEN pair.square > 0 THEN pair.square END) AS square,
      MIN(CASE WHEN pair.largest > 0 THEN pair.largest END) AS largest,
      MAX(CASE WHEN pair.square > 0 THEN 0 ELSE 1 END) AS twin,
      1 AS hit
    FROM measured AS pair
    GROUP BY channel_id, place
  ) AS seen ON seen.channel_id = waiting.channel_id AND seen.place = waiting.place
  WHERE waiting.settled = 0
) AS searched
