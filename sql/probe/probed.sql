-- Probed: each picked vector with the samples that it would hold if the machine were slower, faster or as it is: those
-- of calibration, in its segment, not missing.
-- Reads:  codes, picked
-- A row:  one picked vector; a sample is NULL where there is no such.
-- Slots:  :told     columns of codes that tell where a segment begins, where one may
--         :delayed  value_1, value_2, ... the values so many samples before, and other columns over the same order
--         :reached  x_1, x_2, ... the same, each where it counts
SELECT
  vector.support_id AS support_id,
  vector.number AS number,
  vector.block AS block,
  placed.x_0 AS x_0,
  :reached
FROM (
  SELECT
    channel_id,
    time,
    known_value AS x_0,
    :delayed,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) AS position
  FROM (
    SELECT
      channel_id,
      time,
      :told,
      CASE WHEN code > 0 AND calibrating = 1 THEN value END AS known_value
    FROM codes
  ) AS sound
) AS placed
JOIN picked AS vector ON vector.channel_id = placed.channel_id AND vector.time = placed.time
