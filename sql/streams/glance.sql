-- Glance: the names in some rows of the source that lie together, to guess whether channels lie one after another.
-- Reads:  readings
-- A row:  one (asset, channel) pair.
-- Slots:  :rows  that are looked at
--         :skip  rows before them
SELECT asset, channel
FROM (
  SELECT asset, channel
  FROM readings
  LIMIT :rows
  OFFSET :skip
) AS glanced_at
GROUP BY asset, channel
