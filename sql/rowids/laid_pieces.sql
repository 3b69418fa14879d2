-- Pieces of what is laid: as rowids/pieces.sql, where rows have their names. For SQLite, where rows that lie in order
-- need no sort. Proof: it is one: a piece begins, too, where a row comes before the one that it follows; then
-- misplaced = 1, and readings are sorted after all.
-- Dialect: sqlite
-- Reads:  lined
-- A row:  one piece, in order: its name, its first row and its last.
SELECT
  part.asset AS asset,
  part.channel AS channel,
  part.first_row AS first_row,
  COALESCE(
    LEAD(part.first_row, 1) OVER (ORDER BY part.first_row) - 1, (SELECT MAX(rowid) FROM lined)
  ) AS last_row,
  part.misplaced AS misplaced,
  part.doubled AS doubled
FROM (
  SELECT
    newest.asset AS asset,
    newest.channel AS channel,
    newest.rowid AS first_row,
    CASE
      WHEN previous.rowid IS NULL THEN 0
      WHEN (newest.asset, newest.channel) > (previous.asset, previous.channel) THEN 0
      WHEN (newest.asset, newest.channel) = (previous.asset, previous.channel)
        AND (previous.time IS NULL OR newest.time >= previous.time) THEN 0
      ELSE 1
    END AS misplaced,
    CASE
      WHEN (newest.asset, newest.channel, newest.time) = (previous.asset, previous.channel, previous.time) THEN 1
      ELSE 0
    END AS doubled
  FROM lined AS newest
  LEFT JOIN lined AS previous ON previous.rowid = newest.rowid - 1
  WHERE
    previous.channel IS DISTINCT FROM newest.channel
    OR previous.asset IS DISTINCT FROM newest.asset
    OR newest.time <= previous.time
    OR (newest.time IS NULL AND previous.time IS NOT NULL)
    OR newest.rowid % (SELECT MAX(rowid) / 1024 + 8 FROM lined) = 0
) AS part
ORDER BY first_row
