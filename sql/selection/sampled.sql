-- Sampled: the vectors among which neighbours are looked for. Of a long channel they are about :most, those of
-- pairs.sql: it is unfolded by what its states are like, not by how many of them are known.
-- Reads:  embedded, extents
-- A row:  one vector.
-- Slots:  :carried  u_0, u_1 and so on
--         :most     samples of a channel up to which all are taken
SELECT
  vector.channel_id AS channel_id,
  vector.place AS place,
  vector.tau AS tau,
  vector.memory AS memory,
  vector.depth AS depth,
  :carried
FROM embedded AS vector
JOIN extents AS extent ON extent.channel_id = vector.channel_id
WHERE ((vector.place * 40503) % 65536) * extent.samples < 65536 * CAST(:most AS BIGINT)
