-- Followed: one signal of each machine, whose readings say what the machine runs when.
-- Reads:  readings
-- A row:  one reading; channel_id is the name of the machine.
SELECT reading.asset AS channel_id, reading.time AS time, reading.program AS program
FROM readings AS reading
JOIN (
  SELECT asset, MIN(dated.channel) AS channel
  FROM readings AS dated
  WHERE time IS NOT NULL
  GROUP BY asset
) AS lowest ON lowest.asset = reading.asset AND lowest.channel = reading.channel
WHERE reading.time IS NOT NULL
