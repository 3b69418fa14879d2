-- Calibration rows: the closed intervals that each channel learns from. They are fixed: a later build learns
-- from the same.
-- Reads:  channels, declared
-- A row:  one interval of one channel.
SELECT
  named.channel_id AS channel_id,
  piece.time_from AS time_from,
  piece.time_to AS time_to
FROM channels AS named
JOIN declared AS piece ON piece.calibration_no = named.calibration_no
