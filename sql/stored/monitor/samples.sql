-- Samples of a scheduled run: of each instant the smallest value that is not missing (method, section 2).
-- Reads:  readings, cohort
-- A row:  one sample, NULL where it is missing; row_count counts the rows of its instant.
-- Slots:  :gathered  the least program of an instant, where a column says what a machine runs
SELECT
  member.channel_id AS channel_id,
  reading.time AS time,
  MIN(reading.value) AS value,
  0 AS conflict,
  :gathered,
  CAST(COUNT(*) AS BIGINT) AS row_count
FROM readings AS reading
JOIN cohort AS member ON member.channel_id = reading.channel_id
WHERE reading.time BETWEEN member.read_from AND member.read_until
GROUP BY member.channel_id, reading.time
