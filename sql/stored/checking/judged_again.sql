-- Judged again: the judgements that there must be, with what they say.
-- Reads:  opened, rejudged_windows, kept_judgements
-- A row:  one judgement of one version.
SELECT
  said.channel_id AS channel_id,
  said.judgement_no AS judgement_no,
  counted.bucket_no AS bucket_no,
  counted.run_id AS run_id,
  counted.first_time AS first_time,
  counted.last_time AS last_time,
  counted.novel AS novel,
  said.root AS root,
  said.reference AS reference,
  said.height AS height,
  CASE WHEN known.hit = 1 THEN known.evidence ELSE said.evidence END AS evidence,
  said.is_open AS is_open,
  said.last_zero AS last_zero
FROM opened AS said
JOIN rejudged_windows AS counted
  ON counted.channel_id = said.channel_id AND counted.judgement_no = said.judgement_no
LEFT JOIN (
  SELECT channel_id, judgement_no, evidence, 1 AS hit
  FROM kept_judgements
  WHERE judgement_no < known_until
) AS known ON known.channel_id = said.channel_id AND known.judgement_no = said.judgement_no
