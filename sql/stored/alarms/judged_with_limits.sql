-- Judged with limits: the judgements that a run makes, and the 50 before them, each beside its limit (alarms, section 4).
-- Reads:  judged_windows, judged_until, limit_spans, stored_visible_judgement
-- A row:  one judgement; of one that stays it is known whether it is open, and its last_zero.
-- Slots:  :root  the expression of alarms/root.sql
--         :near  a condition on bucket that holds for all that stay
SELECT
  judgement.channel_id AS channel_id,
  0 AS limit_no,
  judgement.judgement_no AS judgement_no,
  judgement.root AS root,
  span.reference AS reference,
  span.height AS height,
  span.cap AS cap,
  span.from_judgement AS judged_from,
  judgement.prior_open AS prior_open,
  judgement.prior_zero AS prior_zero
FROM (
  SELECT
    judged.channel_id AS channel_id,
    judged.judgement_no AS judgement_no,
    :root AS root,
    -1 AS prior_open,
    CAST(NULL AS BIGINT) AS prior_zero
  FROM judged_windows AS judged
  UNION ALL
  SELECT
    part.channel_id AS channel_id,
    bucket.judgement_no AS judgement_no,
    bucket.root AS root,
    bucket.is_open AS prior_open,
    bucket.last_zero AS prior_zero
  FROM stored_visible_judgement AS bucket
  JOIN judged_until AS part ON part.version_id = bucket.version_id
  WHERE bucket.judgement_no < part.first_judgement
    AND bucket.judgement_no >= part.first_judgement - 50
    AND :near
) AS judgement
JOIN limit_spans AS span
  ON span.channel_id = judgement.channel_id
  AND judgement.judgement_no >= span.from_judgement
  AND judgement.judgement_no < span.until_judgement
