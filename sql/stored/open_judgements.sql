-- Open judgements: the stored judgements of a cohort that belong to an episode.
-- Reads:  cohort, stored_visible_judgement
-- A row:  one judgement.
SELECT
  part.channel_id AS channel_id,
  0 AS limit_no,
  known.judgement_no AS judgement_no,
  known.is_open AS is_open,
  known.last_zero AS last_zero
FROM stored_visible_judgement AS known
JOIN cohort AS part ON part.version_id = known.version_id
WHERE known.is_open = 1
