-- Probes: the vectors whose neighbours are looked for: those first drawn of the ones that can be
-- followed. nearby is the Theiler window: what is not further away in time is no neighbour.
-- Reads:  draws
-- A row:  one reference vector of one channel.
-- Slots:  :d           coordinates
--         :carried     u_0 ... u_d, the one to be followed to included
--         :theiler     the user's own window, NULL for the larger of (d - 1) tau and the memory
--         :references  how many
SELECT channel_id, place, nearby, :carried
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
    CAST(
      ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY scattered, place) AS BIGINT
    ) AS turn
  FROM draws
  WHERE depth > :d
) AS drawn
WHERE turn <= :references
