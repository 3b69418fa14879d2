-- Fleet: what is known of every channel now, one row each. There are no episodes here, so all are judged by their
-- indicator: hi > hi_limit is true of the channels whose status is high, and of no other.
-- Reads:  stored_channel, certified, judged
-- A row:  one channel.
-- Slots:  :times   last_time and since_time as the source tells time; nothing where it counts
--         :window  W, in vectors
SELECT
  channel_row.asset AS asset,
  channel_row.channel AS channel,
  learnt.verdict AS verdict,
  judgement.status AS status,
  judgement.urgency AS urgency,
  judgement.needs_attention AS needs_attention,
  judgement.is_above AS is_above,
  judgement.judged_by AS judged_by,
  judgement.is_far_above AS is_far_above,
  judgement.strength AS strength,
  learnt.floor AS floor,
  learnt.floor_sd AS floor_sd,
  learnt.floor_max AS floor_max,
  judgement.hi_limit AS hi_limit,
  judgement.limit_reason AS limit_reason,
  judgement.hi AS hi,
  judgement.hi_highest AS hi_highest,
  judgement.novel_in_window AS novel_in_window,
  judgement.novel_window_before AS novel_window_before,
  judgement.out_of_range_in_window AS out_of_range_in_window,
  CAST(:window AS BIGINT) AS window_length,
  judgement.bucket AS bucket,
  judgement.buckets AS buckets,
  judgement.novel_in_buckets AS novel_in_buckets,
  :times,
  judgement.last_tick AS last_tick,
  judgement.since_tick AS since_tick,
  learnt.calibration_vectors AS calibration_vectors,
  learnt.cells AS cells,
  learnt.calibrated_lo AS calibrated_lo,
  learnt.calibrated_hi AS calibrated_hi,
  learnt.finest_bins AS finest_bins,
  learnt.vectors_needed AS vectors_needed,
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
  CASE
    WHEN learnt.vouched_by = 1 THEN 'not vouched: only ' || learnt.taught_by || ' taught'
    WHEN learnt.vouched_by > 1 THEN 'judged by ' || learnt.taught_by || '; of itself nothing is known'
  END AS vouching
FROM stored_channel AS channel_row
JOIN certified AS learnt ON learnt.channel_id = channel_row.channel_id
JOIN judged AS judgement ON judgement.channel_id = channel_row.channel_id
