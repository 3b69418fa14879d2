-- Bucket ends: when the newest buckets of each channel of a monitor that counts ended, and its newest row was.
-- Reads:  stored_fleet, stored_monitor, stored_visible_bucket
-- A row:  one bucket, or the newest row of a channel.
-- Slots:  :monitor  its name
--         :newest   how many buckets are looked at
SELECT
  watched.asset AS asset,
  watched.channel AS channel,
  watched.stride AS stride,
  ended.last_time AS end_time
FROM stored_fleet AS watched
JOIN stored_monitor AS counting ON counting.name = watched.monitor
JOIN stored_visible_bucket AS ended ON ended.version_id = watched.version_id
WHERE watched.monitor = :monitor
  AND counting.time_kind = 'counter'
  AND ended.bucket_no > watched.bucket - :newest
UNION ALL
SELECT
  watched.asset AS asset,
  watched.channel AS channel,
  watched.stride AS stride,
  watched.data_tick AS end_time
FROM stored_fleet AS watched
JOIN stored_monitor AS counting ON counting.name = watched.monitor
WHERE watched.monitor = :monitor AND counting.time_kind = 'counter' AND watched.data_tick IS NOT NULL
