-- Edge samples: the samples of the edges, in order.
-- Reads:  near_edges, edges
-- A row:  one sample; place counts the samples of its channel up to it.
SELECT
  sampled.channel_id AS channel_id,
  sampled.time AS time,
  sampled.value AS value,
  part.samples_before + CAST(
    ROW_NUMBER() OVER (
      PARTITION BY sampled.channel_id, part.samples_before ORDER BY sampled.time
    ) AS BIGINT
  ) AS place
FROM near_edges AS sampled
JOIN edges AS part
  ON part.channel_id = sampled.channel_id
  AND sampled.time BETWEEN part.first_time AND part.last_time
WHERE part.is_edge = 1
