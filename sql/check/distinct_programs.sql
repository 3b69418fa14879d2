-- Distinct programs: how many different values columns have that may say what a machine runs.
-- Reads:  source, the relation that holds the telemetry.
-- A row:  one, with a column for each of them.
-- Slots:  :counts     each of them, by check/distinct_count.sql
--         :condition  the user's condition, TRUE where there is none
SELECT CAST(COUNT(*) AS BIGINT) AS readings, :counts
FROM source
WHERE :condition
