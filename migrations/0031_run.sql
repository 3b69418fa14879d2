-- Run, changed: since when the signal stood still at the end of what was read.
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS still_since BIGINT;

COMMENT ON COLUMN stored_run.still_since
  IS 'Time from which on the signal stood still up to the newest sample read; NULL if it moved, or without still_after';
