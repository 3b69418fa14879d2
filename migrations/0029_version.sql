-- Version, changed: from how many equal samples on a signal counts as standing still, and how many vectors of
-- calibration its verdict asked for.
ALTER TABLE stored_version ADD COLUMN IF NOT EXISTS still_after BIGINT;
ALTER TABLE stored_version ADD COLUMN IF NOT EXISTS least_vectors BIGINT;

COMMENT ON COLUMN stored_version.still_after
  IS 'Equal samples in a row from which on the signal stands still and counts as missing; NULL for never';
COMMENT ON COLUMN stored_version.least_vectors
  IS 'Calibration vectors below which the verdict is needs_data; NULL for any number, in versions of before';
