-- Range counts, one channel: its calibration samples in 128 equal pieces of the range that is left; as
-- range/range_counts.sql. For DuckDB, which leaves out most rows of other channels where they lie apart: no name is joined.
-- Proof: that of streams/calibrated.sql, of the same rows.
-- Reads:  readings
-- A row:  one piece that holds samples.
-- Slots:  :asset, :channel
--         :time_from, :time_to  the instants of calibration
--         :lo, :hi   the range that is left of its support. Not joined: a join hands on small pieces of rows late.
--         :allowed   how many samples may be dropped; NULL until they are counted
--         :piece     the expression of range/piece.sql
SELECT
  CAST(:allowed AS BIGINT) AS allowed,
  piece,
  CAST(COUNT(*) AS BIGINT) AS samples,
  MIN(cut.value) AS lowest,
  MAX(cut.value) AS highest
FROM (
  SELECT value, CAST(:piece AS INTEGER) AS piece
  FROM (
    SELECT reading.reading AS value, :lo AS lo, :hi AS hi
    FROM readings AS reading
    WHERE reading.asset = :asset
      AND reading.channel = :channel
      AND reading.time BETWEEN :time_from AND :time_to
      AND reading.reading BETWEEN :lo AND :hi
  ) AS ranged
) AS cut
GROUP BY piece
