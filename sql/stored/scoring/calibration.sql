-- Calibration, stored form: the intervals that were resolved when the version was made.
-- Reads:  stored_calibration, cohort
-- A row:  one interval of one channel.
SELECT
  member.channel_id AS channel_id,
  piece.time_from AS time_from,
  piece.time_to AS time_to
FROM stored_calibration AS piece
JOIN cohort AS member ON member.version_id = piece.version_id
