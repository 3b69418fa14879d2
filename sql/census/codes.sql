-- Codes: the samples of a range of time, coded (Phi, method section 3), straight from the readings. A sample is
-- coded once and its code is delayed, not its value: all delays share one range.
-- Reads:  readings, scale
-- A row:  one sample. What is not a number between -1e300 and 1e300 is missing.
-- Slots:  :code     the expression of support/code.sql, cast to the narrowest integer that holds it
--         :read     which samples are read
--         :carried  columns that travel with the sample
SELECT channel_id, support_id, time, :code AS code, :carried
FROM (
  SELECT
    scale.channel_id AS channel_id,
    scale.support_id AS support_id,
    reading.time AS time,
    CASE
      WHEN reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE)
        THEN reading.reading
    END AS value,
    scale.lo AS lo,
    scale.hi AS hi
  FROM readings AS reading
  JOIN scale ON scale.asset = reading.asset AND scale.channel = reading.channel
  WHERE :read
) AS ranged
