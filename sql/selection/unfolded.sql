-- Unfolded: the vectors with one coordinate more, k * tau samples ahead in the same run; tau differs by
-- channel, so the coordinate is joined by its place. Neighbours are followed into the future, as Kennel
-- does; read from its last sample the same vector is that of Eq. 1. Chained by Python.
-- Reads:  origins, points
-- A row:  one usable sample, with its coordinates as far as depth says.
-- Slots:  :coordinates  the ones there are, with their codes
--         :carried      the same, outside
--         :ahead        the new one, with its code
--         :k            its number
SELECT
  held.channel_id AS channel_id,
  held.run_no AS run_no,
  held.place AS place,
  held.tau AS tau,
  held.memory AS memory,
  CASE WHEN held.depth = :k AND later.hit = 1 THEN held.depth + 1 ELSE held.depth END AS depth,
  :carried,
  :ahead
FROM (
  SELECT
    channel_id,
    run_no,
    place,
    tau,
    memory,
    depth,
    :coordinates,
    place + :k * tau AS place_ahead
  FROM origins
) AS held
LEFT JOIN (
  SELECT channel_id, run_no, place, u_0, c_0, 1 AS hit
  FROM points
) AS later
  ON later.channel_id = held.channel_id
  AND later.run_no = held.run_no
  AND later.place = held.place_ahead
