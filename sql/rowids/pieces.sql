-- Pieces: where slices lie among the lined readings. A piece begins with a name, every so many rows as make a
-- thousand pieces of large sources, and where a row has the name and instant of the one that it follows. For SQLite,
-- which need not sort for groups that are parts of a table in order. Proof: doubled = 1 where an instant occurs
-- twice, and its channel is done again by windows.
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
  part.doubled AS doubled
FROM (
  SELECT
    newest.name_no AS name_no,
    newest.rowid AS first_row,
    CASE WHEN newest.time = previous.time AND newest.name_no = previous.name_no THEN 1 ELSE 0 END AS doubled
  FROM lined AS newest
  LEFT JOIN lined AS previous ON previous.rowid = newest.rowid - 1
  WHERE
    previous.name_no IS DISTINCT FROM newest.name_no
    OR newest.time = previous.time
    OR newest.rowid % (SELECT MAX(rowid) / 1024 + 8 FROM lined) = 0
) AS part
JOIN spoken ON spoken.rowid = part.name_no
ORDER BY first_row
