-- Staying unknown programs: the readings whose program is not judged that stay: those of buckets that do, and those since.
-- Reads:  pruned_versions, horizons, stored_visible_program
-- A row:  all such readings of one bucket, by their key.
SELECT DISTINCT
  visible.version_id AS version_id,
  visible.bucket_no AS bucket_no,
  visible.run_id AS run_id
FROM stored_visible_program AS visible
JOIN pruned_versions AS pruned ON pruned.version_id = visible.version_id
LEFT JOIN (
  SELECT version_id, first_bucket, 1 AS hit
  FROM horizons
) AS horizon ON horizon.version_id = visible.version_id
WHERE pruned.goes = 0
  AND CASE WHEN horizon.hit = 1 AND visible.bucket_no < horizon.first_bucket THEN 0 ELSE 1 END = 1
