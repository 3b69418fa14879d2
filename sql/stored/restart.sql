-- Restart: the last bucket that stays: the one before the first that late rows may still change, because it
-- ends within lookback of the newest one, or at or after the instant that the user wants to be repaired from.
-- Reads:  stored_visible_bucket, newest
-- A row:  one version that has a bucket; last_staying is -1 where none stays. Where older buckets were pruned,
--         the oldest window stays: the rows before it may be gone from the source, too.
-- Slots:  :lookback     in the unit of time; 2^62 for all there is
--         :repair_from  an instant; 2^62 for none
--         :pruned_stay  1; 0 where everything is to be scored anew from the source
SELECT
  reached.version_id AS version_id,
  CASE
    WHEN reached.oldest_bucket * :pruned_stay > 0
      AND reached.oldest_bucket + reached.buckets - 1 > reached.before_first
      THEN reached.oldest_bucket + reached.buckets - 1
    ELSE reached.before_first
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
