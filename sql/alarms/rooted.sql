-- Rooted: the judgements of channels that have a limit, beside it.
-- Reads:  judged_windows, frozen_limits
-- A row:  one judgement.
-- Slots:  :root  the expression of alarms/root.sql
SELECT
  judged.channel_id AS channel_id,
  0 AS limit_no,
  judged.judgement_no AS judgement_no,
  :root AS root,
  frozen.reference AS reference,
  frozen.height AS height,
  frozen.cap AS cap,
  0 AS judged_from,
  -1 AS prior_open,
  CAST(NULL AS BIGINT) AS prior_zero
FROM judged_windows AS judged
JOIN frozen_limits AS frozen ON frozen.channel_id = judged.channel_id
