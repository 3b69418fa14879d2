-- Rounds: the smallest distance above zero in the boxes of this size. It is the nearest of all if it is
-- smaller than a box: what lies outside the boxes searched is further away than that. Else the next
-- round searches larger ones. Zero distances are skipped, and marked.
-- Reads:  unsettled, measured
-- A row:  one reference vector that had no neighbour before this round.
-- Slots:  :reach  the distance below which it is settled
SELECT
  channel_id,
  place,
  nearest,
  twin,
  CASE WHEN nearest < CAST(:reach AS DOUBLE) THEN 1 ELSE 0 END AS settled
FROM (
  SELECT
    waiting.channel_id AS channel_id,
    waiting.place AS place,
    CASE WHEN seen.hit = 1 THEN seen.nearest END AS nearest,
    CASE WHEN seen.hit = 1 THEN seen.twin ELSE 0 END AS twin
  FROM unsettled AS waiting
  LEFT JOIN (
    SELECT
      channel_id,
      place,
      MIN(CASE WHEN distance > CAST(0 AS DOUBLE) THEN distance END) AS nearest,
      MAX(CASE WHEN distance > CAST(0 AS DOUBLE) THEN 0 ELSE 1 END) AS twin,
      1 AS hit
    FROM measured
    GROUP BY channel_id, place
  ) AS seen ON seen.channel_id = waiting.channel_id AND seen.place = waiting.place
  WHERE waiting.settled = 0
) AS searched
