-- Series: each channel's samples in figures.
-- Reads:  channels, timeline, recounted
-- A row:  one channel; quota_time is the time of its floor(fraction * n)-th sample, if calibration
--         is by fraction and that is at least one sample.
SELECT
  named.channel_id AS channel_id,
  named.readings AS samples,
  0 AS conflicts,
  clean.first_time AS first_time,
  clean.quota_time AS quota_time
FROM channels AS named
JOIN timeline AS clean ON clean.channel_id = named.channel_id
WHERE clean.repeats = 0
UNION ALL
SELECT
  again.channel_id AS channel_id,
  again.samples AS samples,
  again.conflicts AS conflicts,
  dirty.first_time AS first_time,
  again.quota_time AS quota_time
FROM recounted AS again
JOIN timeline AS dirty ON dirty.channel_id = again.channel_id
