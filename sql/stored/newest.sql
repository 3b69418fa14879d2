-- Newest: the end of what is stored of each version; there is no other watermark.
-- Reads:  stored_visible_bucket, tails, active
-- A row:  one version that has a bucket; restart_time is the earliest instant that late rows may still change,
--         or that is to be repaired; buckets are those of a window.
-- Slots:  :lookback     in the unit of time; 2^62 for all there is
--         :repair_from  an instant; 2^62 for none
SELECT
  version_id,
  newest_time,
  CASE WHEN newest_time - :lookback < :repair_from THEN newest_time - :lookback ELSE :repair_from END
    AS restart_time,
  buckets
FROM (
  SELECT
    bucket.version_id AS version_id,
    MAX(bucket.last_time) AS newest_time,
    CAST(
      FLOOR(
        (CAST(MIN(frozen.window_length) AS DOUBLE) + CAST(5e-1 AS DOUBLE))
        / CAST(MIN(frozen.stride) AS DOUBLE)
      ) AS BIGINT
    ) AS buckets
  FROM stored_visible_bucket AS bucket
  JOIN active AS frozen ON frozen.version_id = bucket.version_id
  JOIN tails AS ending ON ending.version_id = bucket.version_id
  WHERE bucket.bucket_no BETWEEN ending.tail_from AND 4611686018427387904
  GROUP BY bucket.version_id
) AS ended
