-- Pieces: the readings of each signal that is shown, in its last healthy piece and around the onset.
-- Reads:  samples, channels, wanted_pieces
-- A row:  one reading; piece is healthy or onset. Missing readings are NULL. Positions are counted from the
--         instant that the piece is about, back and, up to the last one that it may hold, forth.
-- Slots:  :most  readings of a piece
--         :programs, :carried  program, where a column says what a machine runs
SELECT
  nearby.number AS number,
  nearby.piece AS piece,
  nearby.time AS time,
  nearby.value AS value,
  :carried
FROM (
  SELECT
    wish.number AS number,
    wish.piece AS piece,
    sampled.time AS time,
    sampled.value AS value,
    :programs,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY wish.number, wish.piece ORDER BY ABS(sampled.time - wish.about_tick), sampled.time
      ) AS BIGINT
    ) AS place
  FROM samples AS sampled
  JOIN channels AS named ON named.channel_id = sampled.channel_id
  JOIN wanted_pieces AS wish ON wish.asset = named.asset AND wish.channel = named.channel
  WHERE sampled.time <= wish.last_tick
) AS nearby
WHERE nearby.place <= :most
