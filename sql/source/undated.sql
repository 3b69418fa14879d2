-- Undated: the rows of the source that tell no time, by their cause, and what local time leaves open.
-- Reads:  source, the relation that holds the telemetry.
-- A row:  the only one. absent: the column is NULL; endless: it is not, and tells no instant; skipped: a local
--         time that no clock shows, with the first and the last such; twice: a local time that comes twice.
-- Slots:  :stored     the time column
--         :instant    the same as integer microseconds, by local time where the source tells that
--         :shift      what local time is ahead of UTC, NULL where no clock shows it; 0 of all other sources
--         :twice      stands there for a local time that comes twice
--         :condition  the user's condition, TRUE where there is none
SELECT
  CAST(COUNT(*) AS BIGINT) - CAST(COUNT(clocked.is_there) AS BIGINT) AS absent,
  CAST(COUNT(clocked.is_there) AS BIGINT) - CAST(COUNT(clocked.instant) AS BIGINT) AS endless,
  CAST(COUNT(CASE WHEN clocked.instant IS NOT NULL AND clocked.shift IS NULL THEN 1 END) AS BIGINT) AS skipped,
  CAST(COUNT(CASE WHEN clocked.shift = :twice THEN 1 END) AS BIGINT) AS twice,
  MIN(CASE WHEN clocked.shift IS NULL THEN clocked.instant END) AS first_skipped,
  MAX(CASE WHEN clocked.shift IS NULL THEN clocked.instant END) AS last_skipped
FROM (
  SELECT clock.is_there AS is_there, clock.clock_time AS instant, :shift AS shift
  FROM (
    SELECT CASE WHEN :stored IS NULL THEN NULL ELSE 1 END AS is_there, :instant AS clock_time
    FROM source
    WHERE :condition
  ) AS clock
) AS clocked
