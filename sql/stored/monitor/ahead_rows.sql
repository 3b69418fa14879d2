-- Ahead rows: the channels of which a run left rows out that are later than now.
-- Reads:  ahead, clock
-- A row:  one channel.
-- Slots:  :monitor_id
SELECT
  CAST(:monitor_id AS BIGINT) AS monitor_id,
  watch.started AS started,
  'ahead' AS kind,
  early.asset AS asset,
  early.channel AS channel,
  early.ahead_rows AS readings,
  early.ahead_to AS latest
FROM ahead AS early
CROSS JOIN clock AS watch
