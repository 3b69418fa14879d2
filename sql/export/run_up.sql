-- Run-up, dbt form: the oldest sample of the first vector that is scored.
-- Reads:  samples, limits
-- A row:  one channel with so many samples before it is scored.
-- Slots:  :span  samples before the newest of a vector
SELECT channel_id, MIN(time) AS run_up_from
FROM (
  SELECT
    sampled.channel_id AS channel_id,
    sampled.time AS time,
    CAST(ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time DESC) AS BIGINT)
      AS steps_back
  FROM samples AS sampled
  JOIN limits AS edge ON edge.channel_id = sampled.channel_id
  WHERE sampled.time < edge.first_scored
) AS backward
WHERE steps_back = :span
GROUP BY channel_id
