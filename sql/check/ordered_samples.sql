-- Ordered samples: each sample beside the one before it, in order of time.
-- Reads:  samples
-- A row:  one sample, numbered from 1 in its channel.
SELECT
  channel_id,
  time,
  value,
  CAST(ROW_NUMBER() OVER (PARTITION BY channel_id ORDER BY time) AS BIGINT) AS position,
  LAG(time, 1) OVER (PARTITION BY channel_id ORDER BY time) AS previous_time,
  LAG(value, 1) OVER (PARTITION BY channel_id ORDER BY time) AS previous_value
FROM samples
