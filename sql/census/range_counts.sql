-- Range counts: the calibration samples of each support in 128 equal pieces of the range that is left; as
-- range/range_counts.sql, straight from the readings.
-- Reads:  readings, calibration, channels, range_before
-- A row:  one piece of one support that holds samples.
-- Slots:  :piece  the expression of range/piece.sql
SELECT
  support_id,
  allowed,
  piece,
  CAST(COUNT(*) AS BIGINT) AS samples,
  MIN(cut.value) AS lowest,
  MAX(cut.value) AS highest
FROM (
  SELECT support_id, allowed, value, CAST(:piece AS INTEGER) AS piece
  FROM (
    SELECT
      whole.support_id AS support_id,
      whole.allowed AS allowed,
      reading.reading AS value,
      whole.lo AS lo,
      whole.hi AS hi
    FROM readings AS reading
    JOIN channels AS named ON named.asset = reading.asset AND named.channel = reading.channel
    JOIN calibration AS healthy ON healthy.channel_id = named.channel_id
    JOIN range_before AS whole ON whole.support_id = named.support_id
    WHERE reading.time BETWEEN healthy.time_from AND healthy.time_to
      AND reading.reading BETWEEN whole.lo AND whole.hi
  ) AS ranged
) AS cut
GROUP BY support_id, allowed, piece
