-- Staying buckets: the buckets that stay: visible, and not older than the horizon.
-- Reads:  horizons, stored_visible_bucket
-- A row:  one of them, by its key.
SELECT
  visible.version_id AS version_id,
  visible.bucket_no AS bucket_no,
  visible.run_id AS run_id
FROM stored_visible_bucket AS visible
JOIN horizons AS horizon ON horizon.version_id = visible.version_id
WHERE visible.bucket_no >= horizon.first_bucket
