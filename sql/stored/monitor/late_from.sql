-- Late from: before which instant older rows of these are looked for; nothing is touched where there are none.
-- Reads:  late
-- A row:  the only one.
-- Slots:  :earliest, :latest  no instant before, or after, can be told
SELECT
  CASE
    WHEN MAX(behind.read_from) > :latest THEN :latest
    WHEN MAX(behind.read_from) > :earliest THEN MAX(behind.read_from)
    ELSE :earliest
  END AS read_from
FROM late AS behind
