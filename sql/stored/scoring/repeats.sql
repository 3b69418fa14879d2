-- Repeats, stored form: does an instant occur twice in what is read? The timeline of a run needs nothing else,
-- since the end of calibration is frozen.
-- Reads:  identified
-- A row:  one channel that has a row in its range; repeats counts the rows beyond the first of an instant.
SELECT
  ordered.channel_id AS channel_id,
  CAST(
    SUM(CASE WHEN ordered.position > 1 AND ordered.time = ordered.previous_time THEN 1 ELSE 0 END)
    AS BIGINT
  ) AS repeats
FROM (
  SELECT
    reading.channel_id AS channel_id,
    reading.time AS time,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY reading.channel_id ORDER BY reading.time) AS BIGINT
    ) AS position,
    LAG(reading.time, 1) OVER (PARTITION BY reading.channel_id ORDER BY reading.time)
      AS previous_time
  FROM identified AS reading
) AS ordered
GROUP BY ordered.channel_id
