-- Size: how many rows the source has, counted up to so many, where that is all that must be known before they are
-- kept in order.
-- Reads:  readings
-- A row:  the only one.
-- Slots:  :most  rows that are counted
SELECT CAST(COUNT(*) AS BIGINT) AS readings
FROM (
  SELECT 1 AS hit
  FROM readings
  LIMIT :most
) AS counted
