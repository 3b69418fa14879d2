-- Samples: one value per instant (method, section 2). Readings of one instant collapse to the smallest
-- that is not missing; only channels that need it pay for the grouping.
-- Reads:  identified, timeline, collapsed
-- A row:  one sample, NULL where it is missing; conflict = 1 where an instant had two different values.
-- Slots:  :programs  program, where a column says what a machine runs
SELECT
  reading.channel_id AS channel_id,
  reading.time AS time,
  reading.value AS value,
  0 AS conflict,
  :programs
FROM identified AS reading
JOIN timeline AS clean ON clean.channel_id = reading.channel_id
WHERE clean.repeats = 0
UNION ALL
SELECT
  single.channel_id AS channel_id,
  single.time AS time,
  single.value AS value,
  single.conflict AS conflict,
  :programs
FROM collapsed AS single
