-- Look from: from where on values of parked channels are looked for; nothing is touched where none is parked.
-- Reads:  parted
-- A row:  the only one.
-- Slots:  :earliest, :latest  no instant before, or after, can be told
SELECT
  CASE
    WHEN MIN(parked.look) < :earliest THEN :earliest
    WHEN MIN(parked.look) < :latest THEN MIN(parked.look)
    ELSE :latest
  END AS read_from
FROM parted AS parked
WHERE parked.part_no = 0
