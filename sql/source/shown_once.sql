-- Shown once: the readings of a source without a zone whose local times come once, in UTC. A local time that no
-- clock shows is no time: NULL, a row all the same.
-- Reads:  source, the readings by local time
-- A row:  one such reading.
-- Slots:  :shift  what the local time is ahead of UTC, NULL where no clock shows it, and
--         :twice  where it comes twice
--         :carried  program, where a column says what a machine runs
SELECT
  clocked.asset AS asset,
  clocked.channel AS channel,
  clocked.local_time - clocked.shift AS time,
  clocked.reading AS reading,
  :carried
FROM (
  SELECT asset, channel, time AS local_time, reading, :carried, :shift AS shift
  FROM source
) AS clocked
WHERE CASE WHEN clocked.shift = :twice THEN 0 ELSE 1 END = 1
