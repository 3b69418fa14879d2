-- As stored: the readings in stored order, with their place and the time of the row before. For engines that
-- hand out rows as they are stored, and follow that where a window has no order (DuckDB).
-- Reads:  readings
-- A row:  one row of the source.
SELECT
  asset,
  channel,
  time,
  reading,
  LAG(time, 1) OVER () AS previous_time,
  CAST(ROW_NUMBER() OVER () AS BIGINT) AS place
FROM readings
