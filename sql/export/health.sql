-- Health: the health indicator at the end of every full bucket, for whoever reads on. Filters on asset,
-- channel, bucket and on the two ticks reach the stored rows.
-- Reads:  stored_channel, certified, stored_bucket
-- A row:  one bucket; hi is NULL until a window is scored.
-- Slots:  :times  first_time and last_time as the source tells time; nothing where it counts
SELECT
  channel_row.asset AS asset,
  channel_row.channel AS channel,
  bucket_row.bucket_no AS bucket,
  :times,
  bucket_row.first_time AS first_tick,
  bucket_row.last_time AS last_tick,
  bucket_row.samples AS samples,
  bucket_row.novel AS novel,
  bucket_row.out_of_range AS out_of_range,
  bucket_row.novel_in_window AS novel_in_window,
  bucket_row.window_length AS window_length,
  CASE
    WHEN bucket_row.novel_in_window IS NOT NULL
      THEN CAST(bucket_row.novel_in_window AS DOUBLE) / CAST(bucket_row.window_length AS DOUBLE)
  END AS hi,
  learnt.verdict AS verdict,
  learnt.hi_limit AS hi_limit,
  learnt.taught_by AS taught_by
FROM stored_bucket AS bucket_row
JOIN stored_channel AS channel_row ON channel_row.channel_id = bucket_row.channel_id
JOIN certified AS learnt ON learnt.channel_id = channel_row.channel_id
WHERE bucket_row.last_time IS NOT NULL
