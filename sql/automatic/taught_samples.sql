-- Taught samples: the samples of calibration in order, by which delays and grids are compared.
-- Reads:  codes
-- A row:  one calibration sample; value is NULL where it is missing or stands still. No vector spans two pieces.
-- Slots:  :piece  which piece of calibration a sample lies in
SELECT
  channel_id,
  code,
  calibration_value AS value,
  piece,
  CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) - 1 AS place,
  CAST(COUNT(*) OVER (PARTITION BY channel_id) AS BIGINT) AS samples
FROM (
  SELECT channel_id, time, code, CASE WHEN code > 0 THEN value END AS calibration_value, calibrating, :piece AS piece
  FROM codes
) AS marked
WHERE calibrating = 1
