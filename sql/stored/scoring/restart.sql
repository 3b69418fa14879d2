-- Restart: the last bucket that stays: the one before the first that late rows may still change, because it
-- ends within lookback of the newest one, or at or after the instant that the user wants to be repaired from.
-- It is searched for among all buckets; what the last run says of it is in recorded.
-- Reads:  stored_visible_bucket, newest
-- A row:  one version that has a bucket; last_staying is -1 where none stays, and the times are NULL. Where
--         older buckets were pruned, the oldest window stays: the rows before it may be gone from the source,
--         too.
-- Slots:  :lookback     in the unit of time; 2^62 for all there is
--         :repair_from  an instant; 2^62 for none
--         :pruned_stay  1; 0 where everything is to be scored anew from the source
SELECT
  again.version_id AS version_id,
  again.oldest_bucket AS oldest_bucket,
  CASE WHEN staying.hit = 1 THEN staying.bucket_no ELSE -1 END AS last_staying,
  CASE WHEN staying.hit = 1 THEN staying.last_time END AS last_time,
  CASE WHEN staying.hit = 1 THEN staying.context_time END AS context_time
FROM (
  SELECT
    version_id,
    oldest_bucket,
    CASE
      WHEN oldest_bucket * :pruned_stay > 0 AND oldest_bucket + buckets - 1 > before_first
        THEN oldest_bucket + buckets - 1
      ELSE before_first
    END AS last_staying
  FROM (
    SELECT
      bucket.version_id AS version_id,
      MIN(ending.oldest_bucket) AS oldest_bucket,
      MIN(ending.buckets) AS buckets,
      MIN(bucket.bucket_no) - 1 AS before_first
    FROM stored_visible_bucket AS bucket
    JOIN newest AS ending ON ending.version_id = bucket.version_id
    WHERE bucket.last_time >= ending.newest_time - :lookback OR bucket.last_time >= :repair_from
    GROUP BY bucket.version_id
  ) AS reached
) AS again
LEFT JOIN (
  SELECT version_id, bucket_no, last_time, context_time, 1 AS hit
  FROM stored_visible_bucket
) AS staying ON staying.version_id = again.version_id AND staying.bucket_no = again.last_staying
