-- Taught before: how many vectors taught a support, and how many of them are those of members before a channel.
-- Reads:  block_sizes
-- A row:  one channel that taught.
SELECT
  channel_id,
  support_id,
  taught,
  CAST(SUM(taught) OVER (PARTITION BY support_id) AS BIGINT) AS vectors,
  CAST(
    SUM(taught) OVER (
      PARTITION BY support_id ORDER BY channel_id ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
    ) AS BIGINT
  ) - taught AS vectors_before
FROM (
  SELECT support_id, channel_id, CAST(SUM(part.vectors) AS BIGINT) AS taught
  FROM block_sizes AS part
  GROUP BY support_id, channel_id
) AS summed
