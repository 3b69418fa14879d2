-- Glance: the names in the first rows of the source, to guess whether channels lie one after another.
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
