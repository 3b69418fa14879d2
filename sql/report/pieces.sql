-- Pieces: the readings of each signal that is shown, in its last healthy piece and around the onset.
-- Reads:  samples, channels, wanted
-- A row:  one reading; piece is healthy or onset. Missing readings are NULL. Positions are counted from the
--         instant that the piece is about, back and forth.
-- Slots:  :most  readings of a piece
SELECT
  placed.number AS number,
  placed.piece AS piece,
  placed.time AS time,
  placed.value AS value
FROM (
  SELECT
    near.number AS number,
    near.piece AS piece,
    near.time AS time,
    near.value AS value,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY near.number, near.piece ORDER BY near.away, near.time) AS BIGINT
    ) AS place
  FROM (
    SELECT
      wish.number AS number,
      'healthy' AS piece,
      sampled.time AS time,
      sampled.value AS value,
      wish.healthy_tick - sampled.time AS away
    FROM samples AS sampled
    JOIN channels AS named ON named.channel_id = sampled.channel_id
    JOIN wanted AS wish ON wish.asset = named.asset AND wish.channel = named.channel
    WHERE sampled.time <= wish.healthy_tick
    UNION ALL
    SELECT
      wish.number AS number,
      'onset' AS piece,
      sampled.time AS time,
      sampled.value AS value,
      CAST(ABS(sampled.time - wish.onset_tick) AS BIGINT) AS away
    FROM samples AS sampled
    JOIN channels AS named ON named.channel_id = sampled.channel_id
    JOIN wanted AS wish ON wish.asset = named.asset AND wish.channel = named.channel
  ) AS near
) AS placed
WHERE placed.place <= :most
