-- Certified: what calibration says of each channel, both sides of it: would a healthy machine stay below the limit, and
-- would a change be seen? A channel that would be ready and sees no shift is blind.
-- Reads:  bounds, verdicts, sight
-- A row:  one channel; sees is the smallest shift seen both ways, in percent of the usual width. All that speaks of
--         changes is NULL where none could be tried.
-- Slots:  :would_not_see  the expression of probe/would_not_see.sql
--         :blind_reason   that of probe/blind_reason.sql
--         :vouched        by how many machines of its pool it is vouched for, which taught, and the floor by leaving out
--                         one of them after another; NULL without pools
SELECT
  channel_id,
  CASE WHEN blind_reason IS NULL THEN certificate ELSE 'blind' END AS verdict,
  vectors,
  cells,
  seen_once,
  blocks,
  floor,
  floor_sd,
  floor_max,
  finest_bins,
  vectors_needed,
  usual_low,
  usual_middle,
  usual_high,
  sees,
  sees_half_stroke,
  sees_frozen,
  sees_faster,
  sees_slower,
  would_not_see,
  blind_reason,
  vouched_by,
  taught_by,
  member_floor
FROM (
  SELECT
    learnt.channel_id AS channel_id,
    learnt.verdict AS certificate,
    learnt.vectors AS vectors,
    learnt.cells AS cells,
    learnt.seen_once AS seen_once,
    learnt.blocks AS blocks,
    learnt.floor AS floor,
    learnt.floor_sd AS floor_sd,
    learnt.floor_max AS floor_max,
    learnt.finest_bins AS finest_bins,
    learnt.vectors_needed AS vectors_needed,
    CASE WHEN probed.hit = 1 THEN probed.usual_low END AS usual_low,
    CASE WHEN probed.hit = 1 THEN probed.usual_middle END AS usual_middle,
    CASE WHEN probed.hit = 1 THEN probed.usual_high END AS usual_high,
    CASE WHEN probed.hit = 1 THEN probed.sees END AS sees,
    CASE WHEN probed.hit = 1 THEN probed.sees_half_stroke END AS sees_half_stroke,
    CASE WHEN probed.hit = 1 THEN probed.sees_frozen END AS sees_frozen,
    CASE WHEN probed.hit = 1 THEN probed.sees_faster END AS sees_faster,
    CASE WHEN probed.hit = 1 THEN probed.sees_slower END AS sees_slower,
    CASE WHEN probed.hit = 1 THEN :would_not_see END AS would_not_see,
    CASE WHEN learnt.verdict = 'ready' AND probed.hit = 1 AND probed.sees IS NULL THEN :blind_reason END
      AS blind_reason,
    :vouched
  FROM verdicts AS learnt
  JOIN bounds AS scale ON scale.channel_id = learnt.channel_id
  LEFT JOIN (
    SELECT
      support_id,
      usual_low,
      usual_middle,
      usual_high,
      usual_width,
      hi_limit,
      sees,
      sees_half_stroke,
      sees_frozen,
      sees_faster,
      sees_slower,
      1 AS hit
    FROM sight
  ) AS probed ON probed.support_id = scale.support_id
) AS weighed
