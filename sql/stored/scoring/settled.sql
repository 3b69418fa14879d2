-- Settled: the last bucket of a run that no row within its lookback can change any more.
-- Reads:  new_buckets, cohort
-- A row:  one version with such a bucket. All three figures grow from bucket to bucket.
SELECT
  bucket.version_id AS version_id,
  MAX(bucket.bucket_no) AS settled_bucket,
  MAX(bucket.last_time) AS settled_time,
  MAX(bucket.context_time) AS settled_context
FROM new_buckets AS bucket
JOIN (
  SELECT version_id, MAX(last_time) AS newest_time
  FROM new_buckets
  GROUP BY version_id
) AS ending ON ending.version_id = bucket.version_id
JOIN cohort AS member ON member.version_id = bucket.version_id
WHERE bucket.last_time < ending.newest_time - member.lookback
GROUP BY bucket.version_id
