-- Unknown rows: the channels without calibration of which a run left rows out.
-- Reads:  names, clock, stored_channel
-- A row:  one channel.
-- Slots:  :monitor_id
SELECT
  CAST(:monitor_id AS BIGINT) AS monitor_id,
  watch.started AS started,
  'unknown' AS kind,
  seen.asset AS asset,
  seen.channel AS channel,
  seen.readings AS readings,
  seen.latest AS latest
FROM names AS seen
CROSS JOIN clock AS watch
LEFT JOIN (
  SELECT named.asset AS asset, named.channel AS channel, 1 AS hit
  FROM stored_channel AS named
  WHERE named.monitor_id = :monitor_id
) AS watched ON watched.asset = seen.asset AND watched.channel = seen.channel
WHERE seen.asset IS NOT NULL
  AND seen.channel IS NOT NULL
  AND seen.readings > 0
  AND CASE WHEN watched.hit = 1 THEN 0 ELSE 1 END = 1
