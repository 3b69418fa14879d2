-- Kept judgements: those that are stored, of the versions whose judgements are made again. The first 50 are taken as
-- they are where pruning took those before.
-- Reads:  judged_until, stored_visible_judgement
-- A row:  one judgement of one version, which is its own channel here.
SELECT
  part.channel_id AS channel_id,
  kept.judgement_no AS judgement_no,
  kept.bucket_no AS bucket_no,
  kept.run_id AS run_id,
  kept.first_time AS first_time,
  kept.last_time AS last_time,
  kept.novel AS novel,
  kept.root AS root,
  kept.reference AS reference,
  kept.height AS height,
  kept.evidence AS evidence,
  kept.is_open AS is_open,
  kept.last_zero AS last_zero,
  CASE WHEN oldest.first_judgement = 0 THEN 0 ELSE oldest.first_judgement + 50 END AS known_until
FROM stored_visible_judgement AS kept
JOIN judged_until AS part ON part.version_id = kept.version_id
JOIN (
  SELECT version_id, MIN(judgement_no) AS first_judgement
  FROM stored_visible_judgement
  GROUP BY version_id
) AS oldest ON oldest.version_id = kept.version_id
