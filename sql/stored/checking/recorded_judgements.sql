-- Recorded judgements: those of the state, from the first one on that the check computes again.
-- Reads:  judged_until, stored_visible_judgement
-- A row:  one judgement.
SELECT
  judgement.version_id AS version_id,
  judgement.bucket_no AS bucket_no,
  judgement.run_id AS run_id,
  judgement.judgement_no AS judgement_no,
  judgement.first_time AS first_time,
  judgement.last_time AS last_time,
  judgement.novel AS novel,
  judgement.root AS root,
  judgement.reference AS reference,
  judgement.height AS height,
  judgement.evidence AS evidence,
  judgement.is_open AS is_open,
  judgement.last_zero AS last_zero
FROM stored_visible_judgement AS judgement
JOIN judged_until AS part ON part.version_id = judgement.version_id
WHERE judgement.judgement_no >= part.first_judgement
