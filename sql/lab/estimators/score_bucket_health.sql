-- Score bucket health: HI (Eq. 2) at the last vector of each full bucket of scored vectors.
-- Reads:  moving_sums, channels
-- A row:  one bucket, in order, numbered from 0.
-- Slots:  :time  the instant as the source tells time
SELECT
  named.asset AS asset,
  named.channel AS channel,
  CAST(
    FLOOR(CAST(counted.number AS DOUBLE) / CAST(counted.bucket_length AS DOUBLE)) AS BIGINT
  ) - 1 AS bucket,
  :time AS last_time,
  CASE
    WHEN counted.number >= counted.window_length
      THEN CAST(counted.units_in_window AS DOUBLE)
        / (CAST(1048576 AS DOUBLE) * CAST(counted.window_length AS DOUBLE))
  END AS hi
FROM moving_sums AS counted
JOIN channels AS named ON named.channel_id = counted.channel_id
WHERE counted.number % counted.bucket_length = 0
ORDER BY named.asset, named.channel, counted.number
