-- Bucket ends: how many samples of the channel there are up to the last vector of a bucket, and where the next
-- vector begins.
-- Reads:  visited
-- A row:  one full bucket of one channel.
SELECT
  visit.channel_id AS channel_id,
  visit.bucket_no AS bucket_no,
  visit.end_position AS end_position,
  visit.context_time AS context_time
FROM visited AS visit
WHERE visit.closing = 1
