-- Undated: the rows that no run can place in time.
-- Reads:  readings
-- A row:  the only one.
SELECT CAST(COUNT(*) AS BIGINT) AS undated
FROM readings
WHERE time IS NULL
