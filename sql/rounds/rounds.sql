-- Rounds: all that must be known of channels to code their samples (census/scale.sql), as lists by their places in a
-- round. For DuckDB: a row finds its channel in them by its number, without a join, which hands on small pieces of
-- rows late. Proof: in_turn (rounds/codes.sql).
-- Dialect: duckdb
-- Reads:  turns, scale
-- A row:  the only one. Of a channel with other parameters the lists hold no more than its name.
-- Slots:  :before  rounds before the first one that is read
--         :after   rounds after which vectors are asked for
--         :sharp   1 if each round must have one instant, as it must where rounds are cut by time
SELECT
  CAST(:before AS BIGINT) AS rounds_before,
  CAST(:after AS BIGINT) AS rounds_after,
  CAST(:sharp AS INTEGER) AS are_sharp,
  LIST(turn.asset ORDER BY turn.place) AS assets,
  LIST(turn.channel ORDER BY turn.place) AS channels,
  LIST(one.channel_id ORDER BY turn.place) AS channel_ids,
  LIST(one.support_id ORDER BY turn.place) AS support_ids,
  LIST(one.lo ORDER BY turn.place) AS los,
  LIST(one.hi ORDER BY turn.place) AS his,
  LIST(one.complete ORDER BY turn.place) AS completes,
  LIST(one.taught_from ORDER BY turn.place) AS taught_froms,
  LIST(one.taught_to ORDER BY turn.place) AS taught_tos,
  LIST(one.read_from ORDER BY turn.place) AS read_froms
FROM turns AS turn
LEFT JOIN scale AS one ON one.asset = turn.asset AND one.channel = turn.channel
