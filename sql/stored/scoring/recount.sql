-- Recount: the different readings that lie in the intervals of calibration: what comes again unchanged counts
-- once, a second value of an instant counts, too. Where it is no longer the number that the version was made
-- from, readings of calibration came, went or changed since.
-- Reads:  identified, calibration
-- A row:  one channel that has such a reading.
SELECT
  channel_id,
  CAST(
    SUM(
      1
      + CASE WHEN lowest < highest THEN 1 ELSE 0 END
      + CASE WHEN missing_rows > 0 AND missing_rows < row_count THEN 1 ELSE 0 END
    ) AS BIGINT
  ) AS calibration_readings
FROM (
  SELECT
    reading.channel_id AS channel_id,
    reading.time AS instant,
    MIN(reading.value) AS lowest,
    MAX(reading.value) AS highest,
    CAST(SUM(CASE WHEN reading.value IS NULL THEN 1 ELSE 0 END) AS BIGINT) AS missing_rows,
    CAST(COUNT(*) AS BIGINT) AS row_count
  FROM identified AS reading
  JOIN calibration AS piece ON piece.channel_id = reading.channel_id
  WHERE reading.time BETWEEN piece.time_from AND piece.time_to
  GROUP BY reading.channel_id, reading.time
) AS counted
GROUP BY channel_id
