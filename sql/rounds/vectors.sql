-- Vectors by rounds: v(t) (Eq. 1) of channels that take turns in the order in which rows are stored, each once in
-- every round: the sample before is the row a round before, and nothing is sorted or joined. For DuckDB. Proof:
-- each row has the names of the channel at its place in the round (in_turn), so that all rows at that place are
-- the channel's and no others are, and it is later than the one a round before; what is not so is marked
-- (rounds/misplaced.sql), and all is done again by embedding/vectors.sql.
-- Dialect: duckdb
-- Reads:  codes
-- A row:  one vector, at the time of its newest sample; cell_key is NULL where a sample is missing;
--         position counts the samples of the channel up to it; context_time is that of the oldest sample of
--         the next vector, from where on a later run must read.
-- Slots:  :delayed   code_1 ... code_(m-1), so many rounds before, and other columns over the same order
--         :context   the time of the oldest sample of the next vector
--         :known     all coordinates are there
--         :cell_key  the mixed-radix integer of the coordinates
--         :outside   a coordinate lies outside the calibrated range
--         :carried   columns that travel with the vector
--         :whole     whether the samples before are those of a vector
--         :asked     which channels' vectors are asked for
SELECT
  channel_id,
  time,
  CASE WHEN :known THEN :cell_key END AS cell_key,
  CASE WHEN :outside THEN 1 ELSE 0 END AS out_of_range,
  position,
  context_time,
  :carried
FROM (
  SELECT
    channel_id,
    complete,
    time,
    code AS code_0,
    :delayed,
    :context AS context_time,
    position,
    rounds_after,
    in_turn
  FROM codes
) AS embedded
WHERE (:whole) AND (position > rounds_after OR in_turn = 0) AND channel_id IS NOT NULL AND :asked
