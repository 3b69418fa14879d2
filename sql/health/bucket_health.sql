-- Bucket health: HI (Eq. 2) at the last vector of each full bucket.
-- Reads:  bucket_counts, channels
-- A row:  one bucket, in order: channels are numbered as their names go.
-- Slots:  :first_time, :last_time  the instants of its first and last vector as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  counted.bucket_no AS bucket,
  :first_time AS first_time,
  :last_time AS last_time,
  CAST(counted.novel AS BIGINT) AS novel,
  CAST(counted.out_of_range AS BIGINT) AS out_of_range,
  CAST(counted.novel_in_window AS BIGINT) AS novel_in_window,
  CASE
    WHEN counted.novel_in_window IS NOT NULL
      THEN CAST(counted.novel_in_window AS DOUBLE) / CAST(counted.window_length AS DOUBLE)
  END AS hi
FROM bucket_counts AS counted
JOIN channels AS named ON named.channel_id = counted.channel_id
ORDER BY counted.channel_id, counted.bucket_no
