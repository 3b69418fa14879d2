-- Instants: those of the first and the last of some samples of one channel, counted by time; where the rounds of a
-- source are cut into pieces. For DuckDB, which works on pieces side by side, and on rows in stored order one after
-- another. Proof: each round of a piece must have one instant (are_sharp, rounds/codes.sql).
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
