-- Places: which round each row is in, and which place it has there. For DuckDB, which numbers rows in the order in
-- which they are stored, and sorts nothing. Proof: in_turn (rounds/codes.sql): the row has the names of the channel
-- at its place.
-- Reads:  readings
-- A row:  one row of the source; position is the number of its round, time_before the time of an earlier row.
-- Slots:  :round  rows of a round: one of each channel
--         :rows   the row so many before is the one whose time is told
SELECT
  asset,
  channel,
  time,
  reading,
  position,
  row_no - (position - 1) * :round AS place,
  time_before
FROM (
  SELECT
    asset,
    channel,
    time,
    reading,
    row_no,
    CAST(FLOOR((row_no - CAST(5e-1 AS DOUBLE)) / CAST(:round AS DOUBLE)) AS BIGINT) + 1 AS position,
    time_before
  FROM (
    SELECT
      asset,
      channel,
      time,
      reading,
      CAST(ROW_NUMBER() OVER () AS BIGINT) AS row_no,
      LAG(time, :rows) OVER () AS time_before
    FROM readings
  ) AS numbered
) AS counted
