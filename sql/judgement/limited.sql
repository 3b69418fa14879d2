-- Limited: what calibration says of each channel, with the limit of its health indicator.
-- Reads:  bounds, certified
-- A row:  one channel.
-- Slots:  :hi_limit, :limit_reason  the expressions of judgement/hi_limit.sql and judgement/limit_reason.sql
SELECT
  learnt.channel_id AS channel_id,
  learnt.verdict AS verdict,
  learnt.vectors AS vectors,
  learnt.cells AS cells,
  learnt.seen_once AS seen_once,
  learnt.blocks AS blocks,
  learnt.floor AS floor,
  learnt.floor_sd AS floor_sd,
  learnt.floor_max AS floor_max,
  learnt.finest_bins AS finest_bins,
  learnt.vectors_needed AS vectors_needed,
  learnt.usual_low AS usual_low,
  learnt.usual_middle AS usual_middle,
  learnt.usual_high AS usual_high,
  learnt.sees AS sees,
  learnt.sees_half_stroke AS sees_half_stroke,
  learnt.sees_frozen AS sees_frozen,
  learnt.sees_faster AS sees_faster,
  learnt.sees_slower AS sees_slower,
  learnt.would_not_see AS would_not_see,
  learnt.blind_reason AS blind_reason,
  learnt.vouched_by AS vouched_by,
  learnt.taught_by AS taught_by,
  learnt.member_floor AS member_floor,
  :hi_limit AS hi_limit,
  :limit_reason AS limit_reason
FROM certified AS learnt
JOIN bounds AS scale ON scale.channel_id = learnt.channel_id
