-- Run, changed: what was read of the end of the source, as one integer. The next run adds the same up again and reads
-- anew only where it differs.
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS summed_from BIGINT;

ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS read_sum BIGINT;

COMMENT ON COLUMN stored_run.summed_from
  IS 'From which time on read_sum counts what was read, up to read_to; NULL if nothing was summed';
COMMENT ON COLUMN stored_run.read_sum
  IS 'Sum of what was read of the channel from there on: of one integer for each row, made of its time and code, or of 1 where the source is said to grow only';
