-- Slices: what the source holds, by name and piece; as census/slices.sql, where readings are lined up. For SQLite,
-- which need not sort for groups that are the rows of another table.
-- Dialect: sqlite
-- Reads:  pieces, lined
-- A row:  one (asset, channel) pair in one slice.
SELECT
  part.asset AS asset,
  part.channel AS channel,
  cut.slice_no AS slice_no,
  cut.readings AS readings,
  cut.without_time AS without_time,
  cut.missing_readings AS missing_readings,
  cut.lowest AS lowest,
  cut.highest AS highest,
  cut.earliest AS earliest,
  cut.latest AS latest
FROM (
  SELECT
    piece.rowid AS slice_no,
    COUNT(reading.time) AS readings,
    COUNT(*) - COUNT(reading.time) AS without_time,
    COUNT(*) - COUNT(reading.value) AS missing_readings,
    MIN(reading.value) AS lowest,
    MAX(reading.value) AS highest,
    MIN(reading.time) AS earliest,
    MAX(reading.time) AS latest
  FROM pieces AS piece
  CROSS JOIN lined AS reading ON reading.rowid BETWEEN piece.first_row AND piece.last_row
  GROUP BY piece.rowid
) AS cut
JOIN pieces AS part ON part.rowid = cut.slice_no
