-- Distinct values: the different values at the beginning of each quarter of a channel's head.
-- Reads:  head_samples
-- A row:  one value of one channel, beside the next smaller one.
-- Slots:  :looked_at  the samples of a quarter that are looked at
SELECT
  level.channel_id AS channel_id,
  level.value AS value,
  level.lowest AS lowest,
  level.highest AS highest,
  CAST(ROW_NUMBER() OVER (PARTITION BY level.channel_id ORDER BY level.value) AS BIGINT) AS rank_no,
  LAG(level.value, 1) OVER (PARTITION BY level.channel_id ORDER BY level.value) AS smaller_value
FROM (
  SELECT
    channel_id,
    value,
    lowest,
    highest
  FROM head_samples
  WHERE value IS NOT NULL AND place < :looked_at
  GROUP BY channel_id, value, lowest, highest
) AS level
