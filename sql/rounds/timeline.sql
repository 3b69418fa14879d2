-- Timeline by rounds: when each channel's samples begin and its calibration quota is reached, of channels that take
-- turns in the order in which rows are stored; see source/timeline.sql. For DuckDB. Proof: misplaced = 0, that is,
-- each row has the names of the channel at its place in the round, and is later than the row a round before.
-- Dialect: duckdb
-- Reads:  readings, rounds
-- A row:  one channel.
-- Slots:  :round  rows of a round: one of each channel
--         :quota  the number of a channel's calibration samples
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
        AND (position = 1 OR time > previous_time)
        THEN 0
      ELSE 1
    END AS misplaced
  FROM (
    SELECT
      asset,
      channel,
      time,
      previous_time,
      position,
      row_no - (position - 1) * :round AS place
    FROM (
      SELECT
        asset,
        channel,
        time,
        previous_time,
        row_no,
        CAST(FLOOR((row_no - CAST(5e-1 AS DOUBLE)) / CAST(:round AS DOUBLE)) AS BIGINT) + 1 AS position
      FROM (
        SELECT
          asset,
          channel,
          time,
          LAG(time, :round) OVER () AS previous_time,
          CAST(ROW_NUMBER() OVER () AS BIGINT) AS row_no
        FROM readings
      ) AS numbered
    ) AS counted
  ) AS in_rounds
  CROSS JOIN rounds
) AS turn
GROUP BY turn.place
