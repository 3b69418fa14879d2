-- Learnt points: the calibration vectors of a support as points, numbered over all members of its pool.
-- Reads:  learnable, coordinates, bounds
-- A row:  one calibration vector.
-- Slots:  :point  x_0 ... x_(m-1)
SELECT
  scale.support_id AS support_id,
  CAST(
    ROW_NUMBER() OVER (PARTITION BY scale.support_id ORDER BY vector.channel_id, vector.time) AS BIGINT
  ) AS number,
  :point
FROM learnable AS vector
JOIN coordinates AS point
  ON point.channel_id = vector.channel_id AND point.time = vector.time
JOIN bounds AS scale ON scale.channel_id = vector.channel_id
