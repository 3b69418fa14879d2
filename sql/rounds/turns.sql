-- Turns: the channels of the first round, one after another. For DuckDB, which keeps the order of rows. Proof: that
-- of rounds/vectors.sql, which holds all other rounds against this one.
-- Reads:  readings
-- A row:  one row of the source, at its place in the round.
-- Slots:  :round  rows of a round: one of each channel
SELECT asset, channel, time, CAST(ROW_NUMBER() OVER () AS INTEGER) AS place
FROM (
  SELECT asset, channel, time
  FROM readings
  LIMIT :round
) AS first_round
