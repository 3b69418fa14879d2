-- Extent: how many rows the source has, and when they begin and end. It decides how times are cut into slices.
-- Reads:  readings
-- A row:  the only one; earliest and latest are NULL where no row has a time.
SELECT CAST(COUNT(*) AS BIGINT) AS readings, MIN(time) AS earliest, MAX(time) AS latest
FROM readings
