-- Shown twice: the readings of a source without a zone whose local times come twice, in UTC. Of a channel's
-- readings at one local time the first one is of the first pass, all others are of the second; which of them came
-- first is not in the data, so they are in order of their values, missing ones last, equal ones by program.
-- Reads:  source, the readings by local time, of such times alone
-- A row:  one such reading.
-- Slots:  :shift, :second  what the local time is ahead of UTC in the first and in the second pass
--         :carried, :ordered  program, where a column says what a machine runs, and what orders by it, none last
SELECT
  clocked.asset AS asset,
  clocked.channel AS channel,
  CASE
    WHEN clocked.place = 1 THEN clocked.local_time - clocked.shift
    ELSE clocked.local_time - clocked.second_shift
  END AS time,
  clocked.reading AS reading,
  :carried
FROM (
  SELECT
    asset,
    channel,
    time AS local_time,
    reading,
    :carried,
    :shift AS shift,
    :second AS second_shift,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY asset, channel, time
        ORDER BY
          CASE WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN 0 ELSE 1 END,
          CASE
            WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN reading
            ELSE CAST(0 AS DOUBLE)
          END,
          :ordered
      ) AS BIGINT
    ) AS place
  FROM source
) AS clocked
