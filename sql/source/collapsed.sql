-- Collapsed: the samples of channels in which an instant occurs twice: the smallest value of each instant
-- that is not missing (method, section 2). The grouping is dear, so it is done once, and only for these.
-- Reads:  identified, timeline
-- A row:  one sample; conflict = 1 where an instant had two different values.
-- Slots:  :conflicting  the expression of source/conflicting.sql
--         :programs, :gathered  program and the least of an instant, where a column says what a machine runs
SELECT
  repeated.channel_id AS channel_id,
  repeated.time AS time,
  MIN(repeated.reading) AS value,
  CASE WHEN :conflicting THEN 1 ELSE 0 END AS conflict,
  :gathered
FROM (
  SELECT reading.channel_id AS channel_id, reading.time AS time, reading.value AS reading, :programs
  FROM identified AS reading
  JOIN timeline AS dirty ON dirty.channel_id = reading.channel_id
  WHERE dirty.repeats > 0
) AS repeated
GROUP BY repeated.channel_id, repeated.time
