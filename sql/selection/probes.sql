-- Probes: the vectors whose neighbours are looked for: a sample of those that can be followed, by a hash
-- of their place in plain integers, the same on every engine. nearby is the Theiler window: what is not
-- further away in time is no neighbour.
-- Reads:  embedded
-- A row:  one reference vector of one channel.
-- Slots:  :d           coordinates
--         :carried     u_0 ... u_d, the one to be followed to included
--         :theiler     the user's own window, NULL for the larger of (d - 1) tau and the memory
--         :seed        of the sample
--         :references  how many
SELECT channel_id, place, nearby, :carried
FROM (
  SELECT
    channel_id,
    place,
    nearby,
    :carried,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY scattered, place) AS BIGINT
    ) AS turn
  FROM (
    SELECT
      channel_id,
      place,
      nearby,
      :carried,
      (mixed * mixed + place) % 2147483647 AS scattered
    FROM (
      SELECT
        channel_id,
        place,
        CASE
          WHEN CAST(:theiler AS BIGINT) >= 0 THEN CAST(:theiler AS BIGINT)
          WHEN (:d - 1) * tau > memory THEN (:d - 1) * tau
          ELSE memory
        END AS nearby,
        :carried,
        ((place % 2147483647) * 48271 + CAST(:seed AS BIGINT)) % 2147483647 AS mixed
      FROM embedded
      WHERE depth > :d
    ) AS folded
  ) AS hashed
) AS drawn
WHERE turn <= :references
