-- Version, changed: how many vectors of calibration its verdict asked for.
ALTER TABLE stored_version ADD COLUMN IF NOT EXISTS least_vectors BIGINT;

COMMENT ON COLUMN stored_version.least_vectors
  IS 'Calibration vectors below which the verdict is needs_data; NULL for any number, in versions of before';
