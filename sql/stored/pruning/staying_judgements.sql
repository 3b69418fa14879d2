-- Staying judgements: those that stay, by the same rule as buckets; but of those that are older than the horizon
-- 51 windows stay, on which evidence may hang.
-- Reads:  pruned_versions, horizons, stored_visible_judgement
-- A row:  one of them, by its key; judgement_no numbers them within their version.
SELECT
  visible.version_id AS version_id,
  visible.bucket_no AS bucket_no,
  visible.judgement_no AS judgement_no,
  visible.run_id AS run_id
FROM stored_visible_judgement AS visible
JOIN horizons AS horizon ON horizon.version_id = visible.version_id
JOIN pruned_versions AS sized ON sized.version_id = visible.version_id
WHERE visible.bucket_no * sized.stride >= horizon.first_bucket * sized.stride - 51 * sized.window_length
