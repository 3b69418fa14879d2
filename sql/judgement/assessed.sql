-- Assessed: each channel with what it is judged by, its limit and its last health indicator.
-- Reads:  channels, limited, bucket_counts
-- A row:  one channel; hi is NULL until a window is scored.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  learnt.verdict AS verdict,
  learnt.hi_limit AS hi_limit,
  learnt.limit_reason AS limit_reason,
  CASE
    WHEN latest.hit = 1 AND latest.novel_in_window IS NOT NULL
      THEN CAST(latest.novel_in_window AS DOUBLE) / CAST(latest.window_length AS DOUBLE)
  END AS hi
FROM channels AS named
JOIN limited AS learnt ON learnt.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, novel_in_window, window_length, 1 AS hit
  FROM (
    SELECT
      channel_id,
      novel_in_window,
      window_length,
      bucket_no,
      MAX(bucket_no) OVER (PARTITION BY channel_id) AS newest_no
    FROM bucket_counts
  ) AS counted
  WHERE bucket_no = newest_no
) AS latest ON latest.channel_id = named.channel_id
