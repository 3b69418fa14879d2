-- Spread: the names in some rows of the source, evenly spread, to guess which there are and whether the rows of each
-- lie together. For DuckDB, which numbers rows as they are stored. Proof: none is needed of a guess; that no name is
-- missing shows when the rows of each are counted (streams/names.sql).
-- Reads:  readings
-- A row:  one (asset, channel) pair of them; rows_in_all is the same in each.
-- Slots:  :every  of so many rows, a power of two, the last one is looked at
--         :mask   every - 1
SELECT
  asset,
  channel,
  CASE WHEN MAX(place) - MIN(place) = :every * (CAST(COUNT(*) AS BIGINT) - 1) THEN 1 ELSE 0 END AS together,
  MAX(counted.rows_in_all) AS rows_in_all
FROM (
  SELECT asset, channel, CAST(ROW_NUMBER() OVER () AS BIGINT) AS place
  FROM readings
) AS numbered
CROSS JOIN (SELECT CAST(COUNT(*) AS BIGINT) AS rows_in_all FROM readings) AS counted
WHERE place & :mask = 0
GROUP BY asset, channel
