-- Glance, by rounds: how many of the first rows have other names than the row a round before, and how many names they
-- have; to guess whether channels take turns, each once in every round. For DuckDB, which keeps the order of rows.
-- Proof: none is needed of a guess; the vectors show whether it was right (rounds/vectors.sql).
-- Reads:  readings
-- A row:  the only one.
-- Slots:  :rows   that are looked at
--         :round  rows of a round: one of each channel
SELECT CAST(SUM(named.misplaced) AS BIGINT) AS misplaced, CAST(COUNT(*) AS BIGINT) AS channels
FROM (
  SELECT
    asset,
    channel,
    SUM(CASE WHEN asset <> asset_before OR channel <> channel_before THEN 1 ELSE 0 END) AS misplaced
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
  GROUP BY asset, channel
) AS named
