-- Checksum, changed: the ends of a range are called so that nobody takes them for a health indicator (hi).
ALTER TABLE stored_checksum ADD COLUMN IF NOT EXISTS calibrated_lo DOUBLE;
ALTER TABLE stored_checksum ADD COLUMN IF NOT EXISTS calibrated_hi DOUBLE;

UPDATE stored_checksum AS kept
SET
  calibrated_lo = COALESCE(kept.calibrated_lo, found.calibrated_lo),
  calibrated_hi = COALESCE(kept.calibrated_hi, found.calibrated_hi)
FROM (
  SELECT version_id, MIN(lo) AS calibrated_lo, MIN(hi) AS calibrated_hi
  FROM stored_checksum
  GROUP BY version_id
) AS found
WHERE kept.version_id = found.version_id;

COMMENT ON COLUMN stored_checksum.calibrated_lo IS 'Smallest calibration value; NULL without calibration';
COMMENT ON COLUMN stored_checksum.calibrated_hi IS 'Largest calibration value; NULL without calibration';
COMMENT ON COLUMN stored_checksum.lo IS 'Earlier name of calibrated_lo: NULL in rows written since';
COMMENT ON COLUMN stored_checksum.hi IS 'Earlier name of calibrated_hi: NULL in rows written since';
