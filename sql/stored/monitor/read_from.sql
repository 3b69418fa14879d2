-- Read from: where a read of the source begins, so that nothing older is touched; no instant where it reads no channel.
-- Reads:  wanted
-- A row:  the only one.
-- Slots:  :among     a condition on part: which of the two reads
--         :earliest  no instant before it can be told
SELECT CASE WHEN MIN(part.read_from) < :earliest THEN :earliest ELSE MIN(part.read_from) END AS read_from
FROM wanted AS part
WHERE :among
