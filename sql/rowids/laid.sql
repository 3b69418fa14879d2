-- Laid: all readings as they are stored, with their names: what stands for lined where the first rows are in order.
-- For SQLite, so that no name is looked for and nothing sorted. Proof: laid_pieces, by misplaced.
-- Dialect: sqlite
-- Reads:  readings
-- A row:  one reading. What is not a number between -1e300 and 1e300 is missing.
SELECT
  asset,
  channel,
  time,
  CASE WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN reading END AS value
FROM readings
