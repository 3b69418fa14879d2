-- Envelope: the lowest and highest reading of each signal that is shown, in equal stretches of time.
-- Reads:  samples, channels, wanted
-- A row:  one stretch in which there is a reading.
SELECT
  place.number AS number,
  place.stretch AS stretch,
  MIN(place.value) AS lowest,
  MAX(place.value) AS highest
FROM (
  SELECT
    wish.number AS number,
    CAST(FLOOR(CAST(sampled.time - wish.first_tick AS DOUBLE) / wish.stretch_length) AS BIGINT) AS stretch,
    sampled.value AS value
  FROM samples AS sampled
  JOIN channels AS named ON named.channel_id = sampled.channel_id
  JOIN wanted AS wish ON wish.asset = named.asset AND wish.channel = named.channel
  WHERE sampled.value IS NOT NULL AND sampled.time >= wish.first_tick
) AS place
GROUP BY place.number, place.stretch
