-- Size: how many rows the source has, where that is all that must be known before they are kept in order.
-- Reads:  readings
-- A row:  the only one.
SELECT CAST(COUNT(*) AS BIGINT) AS readings
FROM readings
