-- Settled: the last bucket of a run that no row within its lookback can change any more.
-- Reads:  new_buckets, cohort
-- A row:  one version with such a bucket. All three figures grow from bucket to bucket.
SELECT
  made.version_id AS version_id,
  MAX(made.bucket_no) AS settled_bucket,
  MAX(made.last_time) AS settled_time,
  MAX(made.context_time) AS settled_context
FROM new_buckets AS made
JOIN (
  SELECT version_id, MAX(last_time) AS newest_time
  FROM new_buckets
  GROUP BY version_id
) AS ending ON ending.version_id = made.version_id
JOIN cohort AS member ON member.version_id = made.version_id
WHERE made.last_time < ending.newest_time - member.lookback
GROUP BY made.version_id
