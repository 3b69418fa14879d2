-- Judged: is a channel above its limit, and who should be looked at first? This is the one place that says it.
-- Reads:  assessed
-- A row:  one channel. judged_by: episode (its calibration gave a limit of judgements), indicator (it gave none; the
--         indicator has hi_limit all the same), or NULL where nothing judges it. status: proving or open (as its episode
--         is), high (its indicator opened the episode; where no episodes are kept, it is above hi_limit), labelled (its
--         episode is a false alarm or a new program, as somebody said), setup (its calibration is not good enough to be
--         watched, or no fair sample of what followed), waiting (less than a window is scored), blind (below its limit, but
--         calibration says that no shift would show), ok, or not assessed (constant in calibration, or none: no alarm,
--         ever). is_above is 1 for proving, open and high, 0 for ok and labelled, NULL where nothing is judged.
--         is_far_above is 1 where the indicator is at ten times hi_limit or more, whatever judges the channel: a remark
--         beside the status. strength, of what is above: its evidence over the height, or the indicator over hi_limit.
--         The larger urgency, the sooner; needs_attention is 1 for setup, and where an episode asks for it, else 0.
-- Slots:  :columns    what is known of a channel, all of which goes on
--         :hi         its health indicator
--         :has_limit  1 where its judgements have a limit, -1 where the indicator opens its episodes, 0 where calibration is
--                     unrepresentative; NULL where no episodes are kept
--         :raised     proving, open or high, as its episode is; NULL without one
--         :label      what somebody said of that episode
--         :sure       evidence of that episode over its height
--         :asks       1 where an episode of it asks for attention
SELECT
  status,
  CASE
    WHEN :asks = 1 AND status = 'proving' THEN 6
    WHEN status = 'high' AND :asks = 0 AND :has_limit IS NOT NULL THEN 2
    WHEN status = 'high' THEN 4
    WHEN :asks = 1 THEN 5
    WHEN status = 'setup' THEN 3
    WHEN status IN ('proving', 'open', 'waiting', 'blind') THEN 2
    WHEN status = 'ok' THEN 1
    ELSE 0
  END AS urgency,
  CASE
    WHEN status = 'high' AND :asks = 0 AND :has_limit IS NOT NULL THEN 0
    WHEN :asks = 1 OR status IN ('high', 'setup') THEN 1
    ELSE 0
  END AS needs_attention,
  CASE WHEN status IN ('proving', 'open', 'high') THEN 1 WHEN status IN ('ok', 'labelled') THEN 0 END AS is_above,
  CASE WHEN judged_by IS NOT NULL AND :hi >= 10 * hi_limit THEN 1 ELSE 0 END AS is_far_above,
  CASE
    WHEN status IN ('proving', 'open') THEN :sure
    WHEN status = 'high' AND hi_limit > 0 THEN :hi / hi_limit
  END AS strength,
  judged_by,
  :columns
FROM (
  SELECT
    CASE
      WHEN verdict IN ('no_data', 'constant') THEN 'not assessed'
      WHEN judged_by IS NULL THEN 'setup'
      WHEN :raised IS NOT NULL AND :label IN ('false_alarm', 'new_program') THEN 'labelled'
      WHEN :raised IS NOT NULL THEN :raised
      WHEN :hi IS NULL THEN 'waiting'
      WHEN judged_by = 'indicator' AND :has_limit IS NULL AND :hi > hi_limit THEN 'high'
      WHEN verdict = 'blind' THEN 'blind'
      ELSE 'ok'
    END AS status,
    judged_by,
    :columns
  FROM (
    SELECT
      CASE
        WHEN verdict <> 'ready' AND verdict <> 'blind' OR :has_limit = 0 THEN NULL
        WHEN :has_limit = 1 THEN 'episode'
        ELSE 'indicator'
      END AS judged_by,
      :columns
    FROM assessed
  ) AS weighed
) AS judged_status
