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
  CAST(counted AS BIGINT) AS place
FROM (
  SELECT
    part.channel_id AS channel_id,
    arrayFlatten(arrayMap((before, number) -> arraySlice(stored.times, before + 1, number), befores, numbers))
      AS time,
    arrayFlatten(arrayMap((before, number) -> arraySlice(stored.samples, before + 1, number), befores, numbers))
      AS reading,
    arrayFlatten(arrayMap((before, number) -> range(before + 1, before + 1 + number), befores, numbers)) AS counted
  FROM stored
  JOIN channels AS named ON named.asset = stored.asset AND named.channel = stored.channel
  JOIN (
    SELECT
      channel_id,
      groupArray(assumeNotNull(edge.samples_before)) AS befores,
      groupArray(assumeNotNull(edge.samples)) AS numbers
    FROM edges AS edge
    WHERE edge.is_edge = 1
    GROUP BY channel_id
  ) AS part ON part.channel_id = named.channel_id
) AS cut
ARRAY JOIN time, reading, counted
