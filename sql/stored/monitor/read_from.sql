-- Read from: where a read of the source begins, so that nothing older is touched, and nothing at all where it is for no
-- channel.
-- Reads:  wanted
-- A row:  the only one.
-- Slots:  :among              a condition on part: which of the two reads
--         :earliest, :latest  no instant before, or after, can be told
SELECT
  CASE
    WHEN MIN(part.read_from) < :earliest THEN :earliest
    WHEN MIN(part.read_from) < :latest THEN MIN(part.read_from)
    ELSE :latest
  END AS read_from
FROM wanted AS part
WHERE :among
