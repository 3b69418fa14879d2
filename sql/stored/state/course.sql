-- Course: how the health indicator of each channel went of late, in at most 64 stretches of buckets. A
-- stretch is one bucket, or so many that 64 stretches hold 8 windows. Of each the highest is taken, so
-- that no peak is lost.
-- Reads:  status_rows, stored_visible_bucket
-- A row:  one stretch of one version, the oldest first; hi is NULL until a window is scored, first_time is when
--         the stretch begins.
SELECT
  version_id,
  stretches_back,
  CASE
    WHEN MAX(stretch_bucket.novel_in_window) IS NOT NULL
      THEN CAST(MAX(stretch_bucket.novel_in_window) AS DOUBLE) / CAST(MAX(stretch_bucket.window_length) AS DOUBLE)
  END AS hi,
  MIN(stretch_bucket.first_time) AS first_time
FROM (
  SELECT
    full_bucket.version_id AS version_id,
    full_bucket.novel_in_window AS novel_in_window,
    full_bucket.first_time AS first_time,
    watched.window_length AS window_length,
    CAST(
      FLOOR(
        CAST(watched.bucket - full_bucket.bucket_no AS DOUBLE) / CAST(watched.stretch AS DOUBLE)
      ) AS BIGINT
    ) AS stretches_back
  FROM stored_visible_bucket AS full_bucket
  JOIN (
    SELECT
      version_id,
      bucket,
      window_length,
      CAST(
        FLOOR(
          (CAST(window_length AS DOUBLE) / CAST(stride AS DOUBLE) + CAST(7 AS DOUBLE))
          / CAST(8 AS DOUBLE)
        ) AS BIGINT
      ) AS stretch
    FROM status_rows
  ) AS watched ON watched.version_id = full_bucket.version_id
) AS stretch_bucket
WHERE stretches_back BETWEEN 0 AND 63
GROUP BY version_id, stretches_back
ORDER BY version_id, stretches_back DESC
