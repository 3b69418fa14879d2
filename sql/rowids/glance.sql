-- Glance, by row: how many of the first rows come before the row that they follow, by name and time; to guess whether
-- the source is stored in order. For SQLite, which numbers rows as it reads them. Proof: none is needed of a guess;
-- laid_pieces shows whether it was right.
-- Dialect: sqlite
-- Reads:  readings
-- A row:  the only one.
-- Slots:  :rows  that are looked at
SELECT COUNT(*) AS misplaced
FROM (
  SELECT
    asset,
    channel,
    time,
    LAG(asset, 1) OVER () AS previous_asset,
    LAG(channel, 1) OVER () AS previous_channel,
    LAG(time, 1) OVER () AS previous_time
  FROM (
    SELECT asset, channel, time
    FROM readings
    LIMIT :rows
  ) AS glanced_at
) AS compared
WHERE (asset, channel, time) < (previous_asset, previous_channel, previous_time)
