-- Spreads: centre and spread of a channel's roots in calibration (alarms, section 2).
-- Reads:  block_roots
-- A row:  one channel, for one g; its sums are those that leaving out subtracts from.
-- Slots:  :centre, :spread  the expressions of alarms/centre.sql and alarms/spread.sql
SELECT
  channel_id,
  g,
  blocks,
  least,
  largest,
  total,
  squares,
  :centre AS centre,
  :spread AS spread
FROM (
  SELECT
    every_root.channel_id AS channel_id,
    every_root.g AS g,
    extent.least AS least,
    MAX(every_root.root) AS largest,
    CAST(COUNT(*) AS BIGINT) AS blocks,
    CAST(SUM(every_root.root - extent.least) AS BIGINT) AS total,
    CAST(
      SUM((every_root.root - extent.least) * (every_root.root - extent.least)) AS BIGINT
    ) AS squares
  FROM block_roots AS every_root
  JOIN (
    SELECT channel_id, g, MIN(root) AS least
    FROM block_roots
    GROUP BY channel_id, g
  ) AS extent ON extent.channel_id = every_root.channel_id AND extent.g = every_root.g
  GROUP BY every_root.channel_id, every_root.g, extent.least
) AS summed
