-- Look from: from where on values of parked channels are looked for; no instant where none is parked.
-- Reads:  parted
-- A row:  the only one.
-- Slots:  :earliest  no instant before it can be told
SELECT CASE WHEN MIN(parked.look) < :earliest THEN :earliest ELSE MIN(parked.look) END AS read_from
FROM parted AS parked
WHERE parked.part_no = 0
