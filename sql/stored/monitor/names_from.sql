-- Names from: from where on rows are counted that belong to no channel: those of the first read, else of the second.
-- Reads:  wanted
-- A row:  the only one.
-- Slots:  :earliest, :latest  no instant before, or after, can be told
SELECT
  CASE
    WHEN begun.read_from < :earliest THEN :earliest
    WHEN begun.read_from < :latest THEN begun.read_from
    ELSE :latest
  END AS read_from
FROM (
  SELECT
    COALESCE(MIN(CASE WHEN part.part_no = 1 THEN part.read_from END), MIN(part.read_from)) AS read_from
  FROM wanted AS part
) AS begun
