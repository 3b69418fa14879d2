-- Glance, by rounds: how many of the first rows have other names than the row a round before; to guess whether
-- channels take turns, each once in every round.
-- Reads:  readings
-- A row:  the only one.
-- Slots:  :rows   that are looked at
--         :round  rows of a round: one of each channel
SELECT CAST(COUNT(*) AS BIGINT) AS misplaced
FROM (
  SELECT
    asset,
    channel,
    LAG(asset, :round) OVER () AS asset_before,
    LAG(channel, :round) OVER () AS channel_before
  FROM (
    SELECT asset, channel
    FROM readings
    LIMIT :rows
  ) AS glanced_at
) AS compared
WHERE asset <> asset_before OR channel <> channel_before
