-- Timeline by rounds: when each channel's samples begin and its calibration quota is reached, of channels that take
-- turns in the order in which rows are stored; as source/timeline.sql. For DuckDB, which numbers a channel's samples
-- by rounds and sorts nothing. Proof: misplaced = 0, that is, each row has the names of the channel at its place in
-- the round, and is later than the row a round before.
-- Dialect: duckdb
-- Reads:  places, rounds
-- A row:  one channel.
-- Slots:  :quota  the number of a channel's calibration samples
SELECT
  MIN(turn.channel_id) AS channel_id,
  CAST(COUNT(*) AS BIGINT) AS readings,
  CAST(SUM(turn.misplaced) AS BIGINT) AS misplaced,
  MIN(turn.time) AS first_time,
  MAX(CASE WHEN turn.position = :quota THEN turn.time END) AS quota_time
FROM (
  SELECT
    LIST_EXTRACT(rounds.channel_ids, place) AS channel_id,
    time,
    position,
    place,
    CASE
      WHEN asset = LIST_EXTRACT(rounds.assets, place)
        AND channel = LIST_EXTRACT(rounds.channels, place)
        AND (position = 1 OR time > time_before)
        THEN 0
      ELSE 1
    END AS misplaced
  FROM places
  CROSS JOIN rounds
) AS turn
GROUP BY turn.place
