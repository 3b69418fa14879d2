-- Health: the health indicator at the end of every full bucket, for whoever reads on. Filters on asset,
-- channel, bucket and on the two ticks reach the stored rows.
-- Reads:  stored_channel, certified, stored_bucket
-- A row:  one bucket; hi is NULL until a window is scored.
-- Slots:  :times  first_time and last_time as the source tells time; nothing where it counts
SELECT
  known.asset AS asset,
  known.channel AS channel,
  made.bucket_no AS bucket,
  :times,
  made.first_time AS first_tick,
  made.last_time AS last_tick,
  made.samples AS samples,
  made.novel AS novel,
  made.out_of_range AS out_of_range,
  made.novel_in_window AS novel_in_window,
  made.window_length AS window_length,
  CASE
    WHEN made.novel_in_window IS NOT NULL
      THEN CAST(made.novel_in_window AS DOUBLE) / CAST(made.window_length AS DOUBLE)
  END AS hi,
  learnt.verdict AS verdict,
  learnt.hi_limit AS hi_limit,
  learnt.taught_by AS taught_by
FROM stored_bucket AS made
JOIN stored_channel AS known ON known.channel_id = made.channel_id
JOIN certified AS learnt ON learnt.channel_id = known.channel_id
WHERE made.last_time IS NOT NULL
