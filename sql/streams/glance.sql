-- Glance: the names in the first rows of the source, to guess whether channels lie one after another. For DuckDB,
-- which keeps the order of rows. Proof: none is needed of a guess; streams/names.sql and the vectors show whether it
-- was right.
-- Reads:  readings
-- A row:  one (asset, channel) pair.
-- Slots:  :rows  that are looked at
SELECT asset, channel
FROM (
  SELECT asset, channel
  FROM readings
  LIMIT :rows
) AS glanced_at
GROUP BY asset, channel
