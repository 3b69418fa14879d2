-- Rejudged with limits: the judgements that there must be, each beside its limit (alarms, section 4).
-- Reads:  rejudged_windows, kept_judgements, limit_spans
-- A row:  one judgement; of one that is taken as it is it is known whether it is open, and its last_zero.
-- Slots:  :root  the expression of alarms/root.sql
SELECT
  judged.channel_id AS channel_id,
  0 AS limit_no,
  judged.judgement_no AS judgement_no,
  :root AS root,
  span.reference AS reference,
  span.height AS height,
  span.cap AS cap,
  span.limit_no AS judged_from,
  CASE WHEN known.hit = 1 THEN known.is_open ELSE -1 END AS known_open,
  CASE WHEN known.hit = 1 THEN known.last_zero END AS known_zero
FROM rejudged_windows AS judged
JOIN limit_spans AS span
  ON span.channel_id = judged.channel_id
  AND judged.judgement_no >= span.from_judgement
  AND judged.judgement_no < span.until_judgement
LEFT JOIN (
  SELECT channel_id, judgement_no, is_open, last_zero, 1 AS hit
  FROM kept_judgements
  WHERE judgement_no < known_until
) AS known ON known.channel_id = judged.channel_id AND known.judgement_no = judged.judgement_no
