-- Edge range: between which instants the slices lie that must be read sample by sample, and how much they hold.
-- Reads:  edges, channels
-- A row:  the only one, NULL where none must be read; readings counts all of each channel, once for each slice.
SELECT
  MIN(part.first_time) AS first_time,
  MAX(part.last_time) AS last_time,
  CAST(SUM(part.samples) AS BIGINT) AS samples,
  CAST(SUM(named.readings) AS BIGINT) AS readings
FROM edges AS part
JOIN channels AS named ON named.channel_id = part.channel_id
WHERE part.is_edge = 1
