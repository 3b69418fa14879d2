-- Judgement rows: what a run appends to the stored judgements.
-- Reads:  opened, judged_windows, judged_buckets, judged_until
-- A row:  one judgement.
SELECT
  part.version_id AS version_id,
  closing.bucket_no AS bucket_no,
  closing.run_id AS run_id,
  said.judgement_no AS judgement_no,
  counted.first_time AS first_time,
  counted.last_time AS last_time,
  counted.novel AS novel,
  said.root AS root,
  said.reference AS reference,
  said.height AS height,
  said.evidence AS evidence,
  said.is_open AS is_open,
  said.last_zero AS last_zero
FROM opened AS said
JOIN judged_until AS part ON part.channel_id = said.channel_id
JOIN judged_windows AS counted
  ON counted.channel_id = said.channel_id AND counted.judgement_no = said.judgement_no
JOIN judged_buckets AS closing
  ON closing.channel_id = counted.channel_id AND closing.bucket_no = counted.last_bucket
