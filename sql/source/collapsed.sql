-- Collapsed: the samples of channels in which an instant occurs twice: the smallest value of each instant
-- that is not missing (method, section 2). The grouping is dear, so it is done once, and only for these.
-- Reads:  readings, channels, timeline
-- A row:  one sample; conflict = 1 where an instant had two different values.
SELECT
  repeated.channel_id AS channel_id,
  repeated.time AS time,
  MIN(repeated.reading) AS value,
  CASE WHEN MIN(repeated.reading) < MAX(repeated.reading) THEN 1 ELSE 0 END AS conflict
FROM (
  SELECT
    named.channel_id AS channel_id,
    reading.time AS time,
    CASE
      WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE)
        THEN reading.reading
    END AS reading
  FROM readings AS reading
  JOIN channels AS named ON named.asset = reading.asset AND named.channel = reading.channel
  JOIN timeline AS dirty ON dirty.channel_id = named.channel_id
  WHERE reading.time IS NOT NULL AND dirty.repeats > 0
) AS repeated
GROUP BY repeated.channel_id, repeated.time
