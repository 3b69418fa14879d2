-- Bucket ends: how many samples of the channel there are up to the last vector of a bucket, and where the next
-- vector begins.
-- Reads:  kept
-- A row:  one full bucket of one channel.
SELECT
  vector.channel_id AS channel_id,
  vector.bucket_no AS bucket_no,
  vector.position AS end_position,
  vector.context_time AS context_time
FROM kept AS vector
WHERE vector.closing = 1
