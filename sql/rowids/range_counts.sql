-- Range counts, by row: the calibration samples of each support in 128 equal pieces of the range that is left; as
-- range/range_counts.sql. For SQLite, which reads the pieces in which calibration lies where they lie. CROSS JOIN keeps it to
-- this order. Proof: pieces, which hold every row once.
-- Dialect: sqlite
-- Reads:  slices, pieces, lined, calibration, channels, range_before
-- A row:  one piece of one support that holds samples.
-- Slots:  :piece  the expression of range/piece.sql
SELECT
  support_id,
  allowed,
  piece,
  COUNT(*) AS samples,
  MIN(cut.value) AS lowest,
  MAX(cut.value) AS highest
FROM (
  SELECT support_id, allowed, value, CAST(:piece AS INTEGER) AS piece
  FROM (
    SELECT
      whole.support_id AS support_id,
      whole.allowed AS allowed,
      reading.value AS value,
      whole.lo AS lo,
      whole.hi AS hi
    FROM range_before AS whole
    CROSS JOIN channels AS named ON named.support_id = whole.support_id
    CROSS JOIN calibration AS healthy ON healthy.channel_id = named.channel_id
    CROSS JOIN slices AS held
      ON held.asset = named.asset
      AND held.channel = named.channel
      AND held.latest >= healthy.time_from
      AND held.earliest <= healthy.time_to
    CROSS JOIN pieces AS part ON part.rowid = held.slice_no
    CROSS JOIN lined AS reading ON reading.rowid BETWEEN part.first_row AND part.last_row
    WHERE reading.time BETWEEN healthy.time_from AND healthy.time_to
      AND reading.value BETWEEN whole.lo AND whole.hi
  ) AS ranged
) AS cut
GROUP BY support_id, allowed, piece
