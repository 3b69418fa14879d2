-- Expired band visits: rows of judgements that go, or that a later run wrote again.
-- Reads:  pruned_versions, horizons, stored_band_visit, stored_visible_judgement
-- A row:  one judgement that a run wrote.
SELECT DISTINCT
  counted.version_id AS version_id,
  counted.judgement_no AS judgement_no,
  counted.run_id AS run_id
FROM stored_band_visit AS counted
JOIN pruned_versions AS pruned ON pruned.version_id = counted.version_id
LEFT JOIN (
  SELECT
    visible.version_id AS version_id,
    visible.judgement_no AS judgement_no,
    visible.run_id AS run_id,
    1 AS hit
  FROM stored_visible_judgement AS visible
  JOIN horizons AS horizon ON horizon.version_id = visible.version_id
  JOIN pruned_versions AS sized ON sized.version_id = visible.version_id
  WHERE visible.bucket_no * sized.stride
    >= horizon.first_bucket * sized.stride - 51 * sized.window_length
) AS staying
  ON staying.version_id = counted.version_id
  AND staying.judgement_no = counted.judgement_no
  AND staying.run_id = counted.run_id
WHERE CASE WHEN staying.hit = 1 THEN 0 ELSE 1 END = 1
