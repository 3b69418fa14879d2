-- Scattered: the vectors, with a hash of their place in plain integers, the same on every engine: the
-- order in which reference vectors are drawn.
-- Reads:  sampled
-- A row:  one vector.
-- Slots:  :carried  u_0, u_1 and so on
--         :seed     of the draw
SELECT
  channel_id,
  place,
  tau,
  memory,
  depth,
  :carried,
  (mixed * mixed + place) % 2147483647 AS scattered
FROM (
  SELECT
    channel_id,
    place,
    tau,
    memory,
    depth,
    :carried,
    ((place % 2147483647) * 48271 + CAST(:seed AS BIGINT)) % 2147483647 AS mixed
  FROM sampled
) AS folded
