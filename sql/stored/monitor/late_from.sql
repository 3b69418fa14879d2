-- Late from: before which instant older rows of these are looked for; no instant where there are none.
-- Reads:  late
-- A row:  the only one.
-- Slots:  :earliest  no instant before it can be told
SELECT CASE WHEN MAX(behind.read_from) < :earliest THEN :earliest ELSE MAX(behind.read_from) END AS read_from
FROM late AS behind
