-- Judged: is a channel high, and who should be looked at first? This is the one place that says it.
-- Reads:  assessed
-- A row:  one channel. status: high (its indicator is above its limit), setup (its calibration is not good enough
--         to be watched), waiting (less than a window is scored), ok, or not assessed (constant in calibration, or
--         none: no alarm, ever). The larger urgency, the sooner; needs_attention is 1 for high and setup, else 0.
-- Slots:  :columns  what is known of a channel, all of which goes on
--         :hi       its health indicator
SELECT
  status,
  CASE status
    WHEN 'high' THEN 4
    WHEN 'setup' THEN 3
    WHEN 'waiting' THEN 2
    WHEN 'ok' THEN 1
    ELSE 0
  END AS urgency,
  CASE WHEN status IN ('high', 'setup') THEN 1 ELSE 0 END AS needs_attention,
  :columns
FROM (
  SELECT
    CASE
      WHEN verdict IN ('no_data', 'constant') THEN 'not assessed'
      WHEN verdict <> 'ready' THEN 'setup'
      WHEN :hi IS NULL THEN 'waiting'
      WHEN :hi > hi_limit THEN 'high'
      ELSE 'ok'
    END AS status,
    :columns
  FROM assessed
) AS told
