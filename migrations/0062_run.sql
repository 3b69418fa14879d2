-- Run, changed: from which bucket on it made anew what is stored. Of those it writes what is not so already, from
-- from_bucket on.
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS made_from BIGINT;

COMMENT ON COLUMN stored_run.made_from
  IS 'First bucket that it made of what it read; those before from_bucket are as they were. NULL: it wrote all of them';
COMMENT ON COLUMN stored_run.context_rows
  IS 'Samples it read up to the end of the bucket before made_from';
COMMENT ON COLUMN stored_run.lookback
  IS 'How late a row may come, as this run took it, in the unit of time; -1 where the next run adds up what this one read';
