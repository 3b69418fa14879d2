-- Scored points: the vectors to be scored as points.
-- Reads:  monitored, coordinates
-- A row:  one vector.
-- Slots:  :point  x_0 ... x_(m-1)
SELECT
  vector.channel_id AS channel_id,
  vector.support_id AS support_id,
  vector.time AS time,
  :point
FROM monitored AS vector
JOIN coordinates AS point
  ON point.channel_id = vector.channel_id AND point.time = vector.time
