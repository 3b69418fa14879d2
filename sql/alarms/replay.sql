-- Replay: the blocks of calibration as judgements, under each height that may be chosen (alarms, section 3).
-- Reads:  left_out, heights
-- A row:  one block of one channel under one height; limit_no is the height in quarters of a spread.
SELECT
  again.channel_id AS channel_id,
  tried.quarters AS limit_no,
  again.block AS judgement_no,
  again.root AS root,
  1000 AS reference,
  250 * tried.quarters AS height,
  CAST(FLOOR(CAST(250 * tried.quarters + 1 AS DOUBLE) / CAST(2 AS DOUBLE)) AS BIGINT) AS cap,
  0 AS judged_from,
  -1 AS prior_open,
  CAST(NULL AS BIGINT) AS prior_zero
FROM left_out AS again
CROSS JOIN heights AS tried
