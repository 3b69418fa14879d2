-- Edge samples, of arrays: the samples of the edges, in order; as census/edge_samples.sql. For ClickHouse, where
-- those of a channel lie beside one another, and their place is known: nothing is sorted. Proof: stored, whose arrays
-- are in order.
-- Dialect: clickhouse
-- Reads:  stored, channels, edges
-- A row:  one sample; place counts the samples of its channel up to it.
SELECT
  channel_id,
  time,
  CASE WHEN NOT isNaN(reading) THEN reading END AS value,
  samples_before + place AS place
FROM (
  SELECT
    part.channel_id AS channel_id,
    part.samples_before AS samples_before,
    arraySlice(stored.times, part.samples_before + 1, part.samples) AS time,
    arraySlice(stored.samples, part.samples_before + 1, part.samples) AS reading
  FROM stored
  JOIN channels AS named ON named.asset = stored.asset AND named.channel = stored.channel
  JOIN (
    SELECT
      channel_id,
      assumeNotNull(MIN(edge.samples_before)) AS samples_before,
      assumeNotNull(SUM(edge.samples)) AS samples
    FROM edges AS edge
    WHERE edge.is_edge = 1
    GROUP BY channel_id
  ) AS part ON part.channel_id = named.channel_id
) AS cut
ARRAY JOIN time, reading, arrayEnumerate(time) AS place
