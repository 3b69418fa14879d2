-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Telemetry: readings once a second, in order of time, the channels taking turns. A channel steps through
-- six levels again and again, with noise of the sensor, in steps of a thousandth; from 60 % of the history
-- on it drifts. The last two channels fall silent before the end; the history is followed by one hour.
-- Numbers that look random are squares modulo a prime: the same ones in every run.
-- Slots:  :channels     those that fall silent included
--         :rows         channels * ticks
--         :history      ticks before the last hour
--         :long_silent, :short_silent  ticks after which the last but one and the last channel are silent
CREATE TABLE readings AS
SELECT
  CASE
    WHEN number < :channels - 2 THEN 'robot_' || LPAD(CAST(number // 6 + 1 AS VARCHAR), 4, '0')
    WHEN number = :channels - 2 THEN 'silent_for_long'
    ELSE 'silent_for_short'
  END AS asset,
  'joint_' || CAST(number % 6 + 1 AS VARCHAR) AS channel,
  CAST('2024-01-01 00:00:00' AS TIMESTAMP) + tick * INTERVAL '1' SECOND AS t,
  ROUND(level + 1e-1 * worn * worn + 3e-2 * noise, 3) AS value
FROM (
  SELECT
    tick,
    number,
    (place * place % 65521) / 32760e0 - 1e0 AS level,
    GREATEST(tick / CAST(:history AS DOUBLE) - 6e-1, 0e0) / 4e-1 AS worn,
    -- A sum of four uniform numbers, of mean 0 and standard deviation 1, is bell-shaped enough.
    (
      (random % 128 + random // 128 % 128 + random // 16384 % 128 + random // 2097152 % 128) / 128e0 - 2e0
    ) * 1.7320508e0 AS noise
  FROM (
    SELECT
      tick,
      number,
      (number * 6 + tick // (20 + number * 17 % 41) % 6 + 1) * 7919 AS place,
      (seed * seed % 2147483647 + 12345) * (seed * seed % 2147483647 + 12345) % 2147483647 AS random
    FROM (
      SELECT
        n // :channels AS tick,
        n % :channels AS number,
        (n * 1103515245 + 12345) % 2147483647 AS seed
      FROM RANGE(0, :rows) AS counted(n)
    ) AS counted_on
  ) AS drawn
  WHERE (number <> :channels - 2 OR tick < :long_silent)
    AND (number <> :channels - 1 OR tick < :short_silent)
) AS followed
