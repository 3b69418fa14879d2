-- Learnt limits: what calibration says of the judgements of each channel, before a height is chosen.
-- Reads:  channels, limited, block_sizes, spreads, order_ratios, lengths, bounds
-- A row:  one channel, for one g; all of it is NULL or 0 where calibration has no block of a window.
-- Slots:  :family_no  which family the channel belongs to
--         :g
SELECT
  named.channel_id AS channel_id,
  named.asset AS asset,
  named.channel AS channel,
  :family_no AS family_no,
  learnt.limit_reason AS limit_reason,
  learnt.hi_limit AS hi_limit,
  scale.window_length AS window_length,
  CAST(:g AS BIGINT) AS g,
  CASE WHEN block_spread.hit = 1 THEN block_spread.blocks ELSE 0 END AS blocks,
  CASE WHEN block_spread.hit = 1 THEN block_spread.largest - block_spread.least END AS extent,
  CASE WHEN block_spread.hit = 1 THEN block_spread.centre END AS centre,
  CASE WHEN block_spread.hit = 1 THEN block_spread.spread END AS spread,
  CASE WHEN ordered.hit = 1 THEN ordered.order_ratio END AS order_ratio,
  CASE WHEN lasting.hit = 1 THEN lasting.length ELSE 0 END AS calibration_length,
  CASE WHEN taught.hit = 1 THEN taught.vectors ELSE 0 END AS vectors
FROM channels AS named
JOIN limited AS learnt ON learnt.channel_id = named.channel_id
JOIN bounds AS scale ON scale.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, blocks, least, largest, centre, spread, 1 AS hit
  FROM spreads
  WHERE g = :g
) AS block_spread ON block_spread.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, order_ratio, 1 AS hit
  FROM order_ratios
) AS ordered ON ordered.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, length, 1 AS hit
  FROM lengths
) AS lasting ON lasting.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, CAST(SUM(size.vectors) AS BIGINT) AS vectors, 1 AS hit
  FROM block_sizes AS size
  GROUP BY channel_id
) AS taught ON taught.channel_id = named.channel_id
