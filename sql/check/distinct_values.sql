-- Distinct values: the different values at the beginning of each quarter of a channel's head, which is read again
-- by its times.
-- Reads:  samples, quarters
-- A row:  one value of one channel, beside the next smaller one.
SELECT
  level.channel_id AS channel_id,
  level.value AS value,
  CAST(ROW_NUMBER() OVER (PARTITION BY level.channel_id ORDER BY level.value) AS BIGINT) AS rank_no,
  LAG(level.value, 1) OVER (PARTITION BY level.channel_id ORDER BY level.value) AS smaller_value
FROM (
  SELECT sampled.channel_id AS channel_id, sampled.value AS value
  FROM samples AS sampled
  JOIN quarters AS part ON part.channel_id = sampled.channel_id
  WHERE sampled.time BETWEEN part.time_from AND part.time_to AND sampled.value IS NOT NULL
  GROUP BY sampled.channel_id, sampled.value
) AS level
