-- Marked codes: as codes, with what decides whether a vector may be learnt: is the sample one of calibration?
-- Reads:  samples, bounds, calibration
-- A row:  one sample.
-- Slots:  :code     the expression of support/code.sql, cast to the narrowest integer that holds it
--         :read     which samples are read
--         :carried  columns that travel with the sample
--         :settings the settings of a channel that are read with its range; none where all channels share them
SELECT channel_id, time, :code AS code, calibrating, :carried
FROM (
  SELECT
    sampled.channel_id AS channel_id,
    sampled.time AS time,
    sampled.value AS value,
    scale.calibrated_lo AS lo,
    scale.calibrated_hi AS hi,
    CAST(CASE WHEN piece.hit = 1 THEN 1 ELSE 0 END AS SMALLINT) AS calibrating,
    :settings
  FROM samples AS sampled
  JOIN bounds AS scale ON scale.channel_id = sampled.channel_id
  LEFT JOIN (
    SELECT channel_id, time_from, time_to, 1 AS hit
    FROM calibration
  ) AS piece
    ON piece.channel_id = sampled.channel_id
    AND sampled.time BETWEEN piece.time_from AND piece.time_to
  WHERE :read
) AS ranged
