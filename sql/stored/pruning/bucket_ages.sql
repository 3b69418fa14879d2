-- Bucket ages: the buckets of the versions that stay, with their age and what a restart needs.
-- Reads:  pruned_versions, recorded, stored_visible_bucket
-- A row:  one bucket; age is counted from the newest bucket of the channel. is_new = 1 if the next run
--         may write it anew: it is not older than lookback, or not settled by what the last run recorded.
-- Slots:  :lookback  how late rows may come
SELECT
  version_id,
  bucket_no,
  window_length,
  stride,
  versions_back,
  newest_of_channel - last_time AS age,
  CASE
    WHEN last_time >= newest_of_version - :lookback THEN 1
    WHEN bucket_no > last_staying THEN 1
    ELSE 0
  END AS is_new
FROM (
  SELECT
    full_bucket.version_id AS version_id,
    full_bucket.bucket_no AS bucket_no,
    full_bucket.last_time AS last_time,
    pruned.window_length AS window_length,
    pruned.stride AS stride,
    pruned.versions_back AS versions_back,
    CASE WHEN run_record.hit = 1 THEN run_record.last_staying ELSE full_bucket.bucket_no END AS last_staying,
    MAX(full_bucket.last_time) OVER (PARTITION BY full_bucket.version_id) AS newest_of_version,
    MAX(full_bucket.last_time) OVER (PARTITION BY pruned.channel_id) AS newest_of_channel
  FROM stored_visible_bucket AS full_bucket
  JOIN pruned_versions AS pruned ON pruned.version_id = full_bucket.version_id
  LEFT JOIN (
    SELECT version_id, last_staying, 1 AS hit
    FROM recorded
  ) AS run_record ON run_record.version_id = full_bucket.version_id
  WHERE pruned.goes = 0
) AS dated
