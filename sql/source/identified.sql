-- Identified: the readings of known channels, by the channel's number. What is not a number between -1e300
-- and 1e300 is missing: NULL here, a tick of the clock all the same (method, section 2).
-- Reads:  readings, channels
-- A row:  one row of the source that has a time and belongs to a channel.
-- Slots:  :read      which readings are read
--         :programs  program, where a column says what a machine runs
SELECT
  named.channel_id AS channel_id,
  reading.time AS time,
  CASE
    WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE)
      THEN reading.reading
  END AS value,
  :programs
FROM readings AS reading
JOIN channels AS named ON named.asset = reading.asset AND named.channel = reading.channel
WHERE reading.time IS NOT NULL AND :read
