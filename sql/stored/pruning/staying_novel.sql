-- Staying novel: the novel cells that stay, by the same rule as buckets, but with a horizon of their own.
-- Reads:  horizons, stored_visible_novel
-- A row:  all novel cells of one bucket, by their key.
SELECT DISTINCT
  visible.version_id AS version_id,
  visible.bucket_no AS bucket_no,
  visible.run_id AS run_id
FROM stored_visible_novel AS visible
JOIN horizons AS horizon ON horizon.version_id = visible.version_id
WHERE visible.bucket_no >= horizon.first_novel
