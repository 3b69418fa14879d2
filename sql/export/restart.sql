-- Restart, dbt form: the last bucket that stays: the one before the first that late rows may still change,
-- because it ends within lookback of the newest one.
-- Reads:  earlier_bucket
-- A row:  one channel of which a bucket stays.
-- Slots:  :lookback  in the unit of time
SELECT
  staying.channel_id AS channel_id,
  staying.bucket_no AS bucket_no,
  staying.last_time AS last_time,
  staying.context_time AS context_time
FROM earlier_bucket AS staying
JOIN (
  SELECT channel_id, MIN(bucket_no) - 1 AS last_staying
  FROM (
    SELECT
      channel_id,
      bucket_no,
      last_time,
      MAX(last_time) OVER (PARTITION BY channel_id) AS newest_time
    FROM earlier_bucket
  ) AS former
  WHERE last_time >= newest_time - :lookback
  GROUP BY channel_id
) AS reached ON reached.channel_id = staying.channel_id AND reached.last_staying = staying.bucket_no
