-- Restart: the last bucket that stays: the one before the first that late rows may still change, because it
-- ends within lookback of the newest one, or at or after the instant that the user wants to be repaired from.
-- Reads:  stored_visible_bucket, newest
-- A row:  one version that has a bucket; last_staying is -1 where none stays. Where older buckets were pruned,
--         the oldest window stays: the rows before it may be gone from the source, too.
-- Slots:  :pruned_stay  1; 0 where everything is to be scored anew from the source
SELECT
  version_id,
  CASE
    WHEN oldest_bucket * :pruned_stay > 0 AND oldest_bucket + buckets - 1 > before_first
      THEN oldest_bucket + buckets - 1
    ELSE before_first
  END AS last_staying
FROM (
  SELECT
    reached.version_id AS version_id,
    reached.buckets AS buckets,
    reached.before_first AS before_first,
    MIN(earlier.bucket_no) AS oldest_bucket
  FROM (
    SELECT
      bucket.version_id AS version_id,
      MIN(ending.buckets) AS buckets,
      MIN(bucket.bucket_no) - 1 AS before_first
    FROM stored_visible_bucket AS bucket
    JOIN newest AS ending ON ending.version_id = bucket.version_id
    WHERE bucket.last_time BETWEEN ending.restart_time AND ending.newest_time
    GROUP BY bucket.version_id
  ) AS reached
  JOIN stored_visible_bucket AS earlier ON earlier.version_id = reached.version_id
  WHERE earlier.bucket_no BETWEEN reached.before_first - reached.buckets + 1 AND reached.before_first + 1
  GROUP BY reached.version_id, reached.buckets, reached.before_first
) AS ranged
