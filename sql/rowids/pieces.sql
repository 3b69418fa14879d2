-- Pieces: where slices lie among the lined readings. A piece begins with a name, every so many rows as make a
-- thousand pieces of large sources, and where a row does not come after the one that it follows. Where it comes
-- before it, misplaced = 1, and readings that were laid are sorted; where it has its name and instant, doubled = 1,
-- and nothing of this body is used. For SQLite.
-- Dialect: sqlite
-- Reads:  lined, spoken
-- A row:  one piece, in order: its name, its first row and its last.
SELECT
  spoken.asset AS asset,
  spoken.channel AS channel,
  part.first_row AS first_row,
  COALESCE(
    LEAD(part.first_row, 1) OVER (ORDER BY part.first_row) - 1, (SELECT MAX(rowid) FROM lined)
  ) AS last_row,
  part.misplaced AS misplaced,
  part.doubled AS doubled
FROM (
  SELECT
    newest.name_no AS name_no,
    newest.rowid AS first_row,
    CASE
      WHEN previous.name_no IS NULL OR newest.name_no > previous.name_no THEN 0
      WHEN newest.name_no = previous.name_no
        AND (previous.time IS NULL OR newest.time >= previous.time) THEN 0
      ELSE 1
    END AS misplaced,
    CASE WHEN newest.time = previous.time AND newest.name_no = previous.name_no THEN 1 ELSE 0 END AS doubled
  FROM lined AS newest
  LEFT JOIN lined AS previous ON previous.rowid = newest.rowid - 1
  WHERE
    previous.name_no IS DISTINCT FROM newest.name_no
    OR newest.time <= previous.time
    OR (newest.time IS NULL AND previous.time IS NOT NULL)
    OR newest.rowid % (SELECT MAX(rowid) / 1024 + 8 FROM lined) = 0
) AS part
JOIN spoken ON spoken.rowid = part.name_no
ORDER BY first_row
