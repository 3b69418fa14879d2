-- Names from: from where on rows are counted that belong to no channel: those of the first read, else of the second.
-- Reads:  wanted
-- A row:  the only one.
-- Slots:  :earliest  no instant before it can be told
SELECT CASE WHEN begun.read_from < :earliest THEN :earliest ELSE begun.read_from END AS read_from
FROM (
  SELECT
    COALESCE(MIN(CASE WHEN part.part_no = 1 THEN part.read_from END), MIN(part.read_from)) AS read_from
  FROM wanted AS part
) AS begun
