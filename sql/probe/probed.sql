-- Probed: each picked vector with the samples that it would hold if the machine were slower, faster or as it is: those
-- of calibration, in its segment, not missing.
-- Reads:  codes, picked
-- A row:  one picked vector; a sample is NULL where there is no such.
-- Slots:  :sample_columns  columns of codes that tell where a segment begins, where one may
--         :delayed         value_1, value_2, ... the values so many samples before, and other columns over that order
--         :reached         x_1, x_2, ... the same, each where it counts
SELECT
  vector.support_id AS support_id,
  vector.number AS number,
  vector.block AS block,
  delay_vector.x_0 AS x_0,
  :reached
FROM (
  SELECT
    channel_id,
    time,
    calibration_value AS x_0,
    :delayed,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) AS position
  FROM (
    SELECT
      channel_id,
      time,
      :sample_columns,
      CASE WHEN code > 0 AND calibrating = 1 THEN value END AS calibration_value
    FROM codes
  ) AS sound
) AS delay_vector
JOIN picked AS vector ON vector.channel_id = delay_vector.channel_id AND vector.time = delay_vector.time
