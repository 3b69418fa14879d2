-- Marked codes: as census/codes.sql, with what decides whether a vector may be learnt where calibration is cut.
-- Reads:  readings, scale, calibration
-- A row:  one sample; calibrating = 1 if it is one of calibration.
-- Slots:  :code     the expression of support/code.sql, cast to the narrowest integer that holds it
--         :read     which samples are read
--         :carried  columns that travel with the sample
SELECT channel_id, support_id, time, :code AS code, calibrating, :carried
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
    scale.hi AS hi,
    CASE WHEN piece.hit = 1 THEN 1 ELSE 0 END AS calibrating
  FROM readings AS reading
  JOIN scale ON scale.asset = reading.asset AND scale.channel = reading.channel
  LEFT JOIN (
    SELECT channel_id, time_from, time_to, 1 AS hit
    FROM calibration
  ) AS piece
    ON piece.channel_id = scale.channel_id
    AND reading.time BETWEEN piece.time_from AND piece.time_to
  WHERE :read
) AS ranged
