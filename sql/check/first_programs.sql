-- First programs: the same of the first rows alone, which show a column of many values for what it is.
-- Reads:  source, the relation that holds the telemetry.
-- A row:  one, with a column for each of them.
-- Slots:  :counts     each of them, by check/distinct_count.sql
--         :columns    the columns
--         :condition  the user's condition, TRUE where there is none
SELECT CAST(COUNT(*) AS BIGINT) AS readings, :counts
FROM (
  SELECT 1 AS looked_at, :columns
  FROM source
  WHERE :condition
  LIMIT 10000
) AS head
