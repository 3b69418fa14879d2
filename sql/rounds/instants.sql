-- Instants: those of the first and the last of some samples of one channel, counted by time; where the rounds of a
-- source are cut into pieces, which are worked on side by side.
-- Reads:  readings
-- A row:  the only one.
-- Slots:  :asset, :channel
--         :skipped, :samples  how many of its samples come before those, and how many they are
SELECT MIN(asked.time) AS earliest, MAX(asked.time) AS latest
FROM (
  SELECT time
  FROM readings
  WHERE asset = :asset AND channel = :channel
  ORDER BY time
  LIMIT :samples OFFSET :skipped
) AS asked
