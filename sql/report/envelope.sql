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
    CAST(FLOOR(CAST(sample.time - wish.first_tick AS DOUBLE) / wish.stretch_length) AS BIGINT) AS stretch,
    sample.value AS value
  FROM samples AS sample
  JOIN channels AS named ON named.channel_id = sample.channel_id
  JOIN wanted AS wish ON wish.asset = named.asset AND wish.channel = named.channel
  WHERE sample.value IS NOT NULL AND sample.time >= wish.first_tick
) AS place
GROUP BY place.number, place.stretch
