-- Judgement rows: what a run appends to the stored judgements.
-- Reads:  opened, judged_windows, judged_buckets, judged_until
-- A row:  one judgement.
SELECT
  part.version_id AS version_id,
  closing.bucket_no AS bucket_no,
  closing.run_id AS run_id,
  judgement_row.judgement_no AS judgement_no,
  counted.first_time AS first_time,
  counted.last_time AS last_time,
  counted.novel AS novel,
  judgement_row.root AS root,
  judgement_row.reference AS reference,
  judgement_row.height AS height,
  judgement_row.evidence AS evidence,
  judgement_row.is_open AS is_open,
  judgement_row.last_zero AS last_zero
FROM opened AS judgement_row
JOIN judged_until AS part ON part.channel_id = judgement_row.channel_id
JOIN judged_windows AS counted
  ON counted.channel_id = judgement_row.channel_id AND counted.judgement_no = judgement_row.judgement_no
JOIN judged_buckets AS closing
  ON closing.channel_id = counted.channel_id AND closing.bucket_no = counted.last_bucket
