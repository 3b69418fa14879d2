-- Repeating calibration: the intervals of calibration of channels in which an instant occurs twice, whose readings
-- must be counted one by one.
-- Reads:  calibration, timeline
-- A row:  one closed interval of such a channel.
SELECT
  piece.channel_id AS channel_id,
  piece.time_from AS time_from,
  piece.time_to AS time_to
FROM calibration AS piece
JOIN timeline AS clock ON clock.channel_id = piece.channel_id
WHERE clock.repeats > 0
