-- Health rows: the health indicator of the channels of one monitor, for whoever asks for a table.
-- Reads:  stored_health
-- A row:  one full bucket, in order.
-- Slots:  :monitor  its name
--         :chosen   which assets and channels are wanted
SELECT
  asset,
  channel,
  version_no,
  bucket,
  first_time,
  last_time,
  first_tick,
  last_tick,
  samples,
  novel,
  out_of_range,
  novel_in_window,
  window_length,
  hi
FROM stored_health
WHERE monitor = :monitor AND :chosen
ORDER BY asset, channel, bucket
