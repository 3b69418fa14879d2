-- Taught days: on how many days (UTC) calibration holds a program. Of a counter it means nothing.
-- Reads:  taught_readings
-- A row:  one program of one channel.
SELECT channel_id, program, CAST(COUNT(*) AS BIGINT) AS days
FROM (
  SELECT channel_id, program, day
  FROM (
    SELECT channel_id, program, time - (time % 86400000000 + 86400000000) % 86400000000 AS day
    FROM taught_readings
    WHERE program IS NOT NULL
  ) AS dated
  GROUP BY channel_id, program, day
) AS daily
GROUP BY channel_id, program
