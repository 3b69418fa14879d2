-- Unplaced, changed: how many of the readings of a run did not count, by the condition that its source was declared
-- with (valid_when). They are missing samples.
ALTER TABLE stored_unplaced ADD COLUMN IF NOT EXISTS held BIGINT;

ALTER TABLE stored_unplaced ADD COLUMN IF NOT EXISTS invalid BIGINT;

COMMENT ON COLUMN stored_unplaced.held
  IS 'Readings of its range that were held to valid_when; NULL where the source has no such condition';
COMMENT ON COLUMN stored_unplaced.invalid IS 'Those of them for which it does not hold, so that they are missing';
