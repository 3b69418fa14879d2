-- Bucket, changed: how many samples stood still.
ALTER TABLE stored_bucket ADD COLUMN IF NOT EXISTS still BIGINT;

COMMENT ON COLUMN stored_bucket.still
  IS 'Samples after the previous bucket up to the end of this one that stood still; NULL without still_after';
COMMENT ON COLUMN stored_bucket.context_time
  IS 'Time of the oldest sample that decides the next vector: where a restart reads from; -2^62 is everything';
