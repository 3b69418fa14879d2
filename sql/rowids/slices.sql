-- Slices: what the source holds, by name and piece; as census/slices.sql, where readings are lined up: in a piece
-- rows without a time come first, and the others in order of time. For SQLite, which need not sort for groups that
-- are the rows of another table. Proof: pieces, which hold every row once, and whose rows are in order.
-- Dialect: sqlite
-- Reads:  pieces, lined
-- A row:  one (asset, channel) pair in one slice.
SELECT
  part.asset AS asset,
  part.channel AS channel,
  cut.slice_no AS slice_no,
  COALESCE(part.last_row + 1 - cut.timed_row, 0) AS readings,
  COALESCE(cut.timed_row, part.last_row + 1) - part.first_row AS without_time,
  part.last_row + 1 - part.first_row - cut.numbers AS missing_readings,
  cut.lowest AS lowest,
  cut.highest AS highest,
  earliest.time AS earliest,
  latest.time AS latest
FROM (
  SELECT
    piece.rowid AS slice_no,
    (
      SELECT MIN(timed.rowid)
      FROM lined AS timed
      WHERE timed.rowid BETWEEN piece.first_row AND piece.last_row AND timed.time IS NOT NULL
    ) AS timed_row,
    COUNT(reading.value) AS numbers,
    MIN(reading.value) AS lowest,
    MAX(reading.value) AS highest
  FROM pieces AS piece
  CROSS JOIN lined AS reading ON reading.rowid BETWEEN piece.first_row AND piece.last_row
  GROUP BY piece.rowid
) AS cut
JOIN pieces AS part ON part.rowid = cut.slice_no
LEFT JOIN lined AS earliest ON earliest.rowid = cut.timed_row
LEFT JOIN lined AS latest ON latest.rowid = part.last_row
