-- Coordinates: v(t) = [x(t), x(t - tau), ..., x(t - (m-1) tau)] (Eq. 1) in normalised values. What lies
-- more than a million ranges away is taken for a million: squares stay finite on every engine. Which
-- vectors may be learnt or scored is not said here but by learnable and monitored.
-- Reads:  samples, bounds
-- A row:  one sample with those before it; x_0 is the newest.
-- Slots:  :normalised  the expression of estimators/normalised.sql
--         :delayed     x_1 ... x_(m-1), the delayed values
SELECT channel_id, time, x_0, :delayed
FROM (
  SELECT
    channel_id,
    time,
    CASE
      WHEN x > CAST(1e6 AS DOUBLE) THEN CAST(1e6 AS DOUBLE)
      WHEN x < CAST(-1e6 AS DOUBLE) THEN CAST(-1e6 AS DOUBLE)
      ELSE x
    END AS x_0
  FROM (
    SELECT
      sampled.channel_id AS channel_id,
      sampled.time AS time,
      :normalised AS x
    FROM samples AS sampled
    JOIN bounds AS scale ON scale.channel_id = sampled.channel_id
  ) AS ranged
) AS limited
