-- Earlier bucket: the buckets that the build before left.
-- Reads:  stored_bucket
-- A row:  one bucket; a row without times marks one that is no more, until it is deleted.
SELECT
  former.channel_id AS channel_id,
  former.bucket_no AS bucket_no,
  former.last_time AS last_time,
  former.context_time AS context_time,
  former.novel AS novel
FROM stored_bucket AS former
WHERE former.last_time IS NOT NULL
