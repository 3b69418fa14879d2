-- Newest: the end of what is stored of each version; there is no other watermark.
-- Reads:  stored_visible_bucket, active
-- A row:  one version that has a bucket; oldest_bucket is 0 unless older ones were pruned, buckets are those
--         of a window.
SELECT
  bucket.version_id AS version_id,
  MAX(bucket.last_time) AS newest_time,
  MIN(bucket.bucket_no) AS oldest_bucket,
  CAST(
    FLOOR(
      (CAST(MIN(frozen.window_length) AS DOUBLE) + CAST(5e-1 AS DOUBLE))
      / CAST(MIN(frozen.stride) AS DOUBLE)
    ) AS BIGINT
  ) AS buckets
FROM stored_visible_bucket AS bucket
JOIN active AS frozen ON frozen.version_id = bucket.version_id
GROUP BY bucket.version_id
