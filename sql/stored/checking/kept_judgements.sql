-- Kept judgements: those that are stored, from the first one on that is made again.
-- Reads:  judged_until, stored_visible_judgement
-- A row:  one judgement.
SELECT
  kept.version_id AS version_id,
  kept.bucket_no AS bucket_no,
  kept.run_id AS run_id,
  kept.judgement_no AS judgement_no,
  kept.first_time AS first_time,
  kept.last_time AS last_time,
  kept.novel AS novel,
  kept.root AS root,
  kept.reference AS reference,
  kept.height AS height,
  kept.evidence AS evidence,
  kept.is_open AS is_open,
  kept.last_zero AS last_zero
FROM stored_visible_judgement AS kept
JOIN judged_until AS part ON part.version_id = kept.version_id
WHERE kept.judgement_no >= part.first_judgement
