-- Longest stills: the longest stretch of samples of one and the same value. Only channels in which a value
-- stays at all pay for this, and beyond the order of their samples only samples that stayed.
-- Reads:  samples, movements
-- A row:  one channel in which two samples in a row are equal.
SELECT
  stretch.channel_id AS channel_id,
  MAX(stretch.samples) AS longest_still
FROM (
  SELECT
    stayed.channel_id AS channel_id,
    CAST(COUNT(*) AS BIGINT) + 1 AS samples
  FROM (
    SELECT
      beside.channel_id AS channel_id,
      beside.position - CAST(
        ROW_NUMBER() OVER (PARTITION BY beside.channel_id ORDER BY beside.time) AS BIGINT
      ) AS moves
    FROM (
      SELECT
        sampled.channel_id AS channel_id,
        sampled.time AS time,
        sampled.value AS value,
        CAST(
          ROW_NUMBER() OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time) AS BIGINT
        ) AS position,
        LAG(sampled.value, 1) OVER (PARTITION BY sampled.channel_id ORDER BY sampled.time)
          AS previous_value
      FROM samples AS sampled
      JOIN movements AS movement ON movement.channel_id = sampled.channel_id
      WHERE movement.stills > 0
    ) AS beside
    WHERE beside.position > 1 AND beside.value = beside.previous_value
  ) AS stayed
  GROUP BY stayed.channel_id, stayed.moves
) AS stretch
GROUP BY stretch.channel_id
