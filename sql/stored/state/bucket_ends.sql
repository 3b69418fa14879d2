-- Bucket ends: when the newest buckets of each channel ended, and when its newest row was.
-- Reads:  status_rows, stored_visible_bucket
-- A row:  one bucket, or the newest row of a channel.
-- Slots:  :newest  how many buckets are looked at
SELECT
  watched.asset AS asset,
  watched.channel AS channel,
  watched.stride AS stride,
  ended.last_time AS end_time
FROM status_rows AS watched
JOIN stored_visible_bucket AS ended ON ended.version_id = watched.version_id
WHERE ended.bucket_no > watched.bucket - :newest
UNION ALL
SELECT
  read_last.asset AS asset,
  read_last.channel AS channel,
  read_last.stride AS stride,
  read_last.last_data AS end_time
FROM status_rows AS read_last
WHERE read_last.last_data IS NOT NULL
