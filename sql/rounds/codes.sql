-- Codes by rounds: the samples of a range of time, coded (Phi, method section 3); as census/codes.sql, where channels
-- take turns in the order in which rows are stored. For DuckDB, which finds a channel by its place at less cost than
-- by its names. Proof: in_turn, which rounds/vectors.sql looks at.
-- Dialect: duckdb
-- Reads:  places, rounds
-- A row:  one row of the range; position is the number of its round, in_turn = 0 if it is not of the channel whose turn
--         it is, or not of what is read of that, or not of the instant that its round must have.
-- Slots:  :code   the expression of support/code.sql, cast to the narrowest integer that holds it
--         :time_from, :time_to  the first and the last instant that are read of a channel
SELECT channel_id, support_id, complete, time, position, rounds_after, in_turn, :code AS code
FROM (
  SELECT
    LIST_EXTRACT(rounds.channel_ids, place) AS channel_id,
    LIST_EXTRACT(rounds.support_ids, place) AS support_id,
    LIST_EXTRACT(rounds.completes, place) AS complete,
    time,
    rounds.rounds_before + position AS position,
    rounds.rounds_after AS rounds_after,
    CASE
      WHEN asset = LIST_EXTRACT(rounds.assets, place)
        AND channel = LIST_EXTRACT(rounds.channels, place)
        AND time BETWEEN :time_from AND :time_to
        AND (place = 1 OR time = time_before OR rounds.are_sharp = 0)
        THEN 1
      ELSE 0
    END AS in_turn,
    CASE
      WHEN reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE) THEN reading
    END AS value,
    LIST_EXTRACT(rounds.los, place) AS lo,
    LIST_EXTRACT(rounds.his, place) AS hi
  FROM places
  CROSS JOIN rounds
) AS ranged
