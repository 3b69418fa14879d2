-- Samples: one value per instant (method, section 2). What is not a number between -1e300 and 1e300
-- is missing: NULL here, a tick of the clock all the same. Readings of one instant collapse to the
-- smallest that is not missing; only channels that need it pay for the grouping.
-- Reads:  readings, channels, timeline, collapsed
-- A row:  one sample; conflict = 1 where an instant had two different values.
SELECT
  named.channel_id AS channel_id,
  reading.time AS time,
  CASE
    WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE)
      THEN reading.reading
  END AS value,
  0 AS conflict
FROM readings AS reading
JOIN channels AS named ON named.asset = reading.asset AND named.channel = reading.channel
JOIN timeline AS clean ON clean.channel_id = named.channel_id
WHERE reading.time IS NOT NULL AND clean.repeats = 0
UNION ALL
SELECT channel_id, time, value, conflict
FROM collapsed
