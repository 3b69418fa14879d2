-- Followed: how far each reference vector and its neighbour part in the next coordinate, in units.
-- Reads:  neighbours, probes, sampled
-- A row:  one reference vector that has a neighbour.
-- Slots:  :next_coordinate, :next_of_neighbour  u_d of both
--         :distance, :neighbour  in the metric, and the place of the nearest
SELECT
  pair.channel_id AS channel_id,
  pair.place AS place,
  :distance AS distance,
  pair.twin AS twin,
  ABS(CAST(:next_coordinate AS BIGINT) - CAST(:next_of_neighbour AS BIGINT)) AS parting
FROM neighbours AS pair
JOIN probes AS probe ON probe.channel_id = pair.channel_id AND probe.place = pair.place
JOIN sampled AS other ON other.channel_id = pair.channel_id AND other.place = :neighbour
