-- Whole: the last bucket that stays where rows have gone from the source, all of them before its oldest: the one before
-- the first bucket whose context is still there whole, else the newest. What is stored up to there cannot be made anew.
-- Where older buckets were pruned, the oldest window stays, too, since sums need it.
-- Reads:  stored_visible_bucket, newest, oldest_rows
-- A row:  one version that has a bucket and an oldest row; begin_time is where its buckets begin.
SELECT
  extent.version_id AS version_id,
  extent.oldest_bucket AS oldest_bucket,
  extent.begin_time AS begin_time,
  extent.last_staying AS last_staying,
  staying.last_time AS last_time,
  staying.context_time AS context_time
FROM (
  SELECT
    bucket.version_id AS version_id,
    MIN(ending.oldest_bucket) AS oldest_bucket,
    MIN(bucket.first_time) AS begin_time,
    COALESCE(
      MIN(
        CASE
          WHEN bucket.context_time < held.oldest_time THEN NULL
          WHEN ending.oldest_bucket > 0 AND bucket.bucket_no < ending.oldest_bucket + ending.buckets - 1 THEN NULL
          ELSE bucket.bucket_no
        END
      ),
      MAX(bucket.bucket_no)
    ) AS last_staying
  FROM stored_visible_bucket AS bucket
  JOIN newest AS ending ON ending.version_id = bucket.version_id
  JOIN oldest_rows AS held ON held.version_id = bucket.version_id
  GROUP BY bucket.version_id
) AS extent
JOIN stored_visible_bucket AS staying
  ON staying.version_id = extent.version_id AND staying.bucket_no = extent.last_staying
