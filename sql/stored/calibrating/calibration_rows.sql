-- Calibration rows: the resolved intervals that a new version keeps.
-- Reads:  calibration, numbering
-- A row:  one closed interval.
SELECT
  numbered.version_id AS version_id,
  piece.time_from AS time_from,
  piece.time_to AS time_to
FROM calibration AS piece
JOIN numbering AS numbered ON numbered.channel_id = piece.channel_id
