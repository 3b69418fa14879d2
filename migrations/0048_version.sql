-- Version, changed: from how many equal samples on a signal counts as standing still.
ALTER TABLE stored_version ADD COLUMN IF NOT EXISTS still_after BIGINT;

COMMENT ON COLUMN stored_version.still_after
  IS 'Equal samples in a row from which on the signal stands still and counts as missing; NULL for never';
