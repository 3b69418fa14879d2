-- Bounds rows: range and certificate of each new support; members of a pool share theirs.
-- Reads:  bounds, certified, numbering
-- A row:  one support.
SELECT
  numbered.stored_support_id AS support_id,
  scale.calibrated_lo AS calibrated_lo,
  scale.calibrated_hi AS calibrated_hi,
  scale.dropped_below AS dropped_below,
  scale.dropped_above AS dropped_above,
  scale.lowest_dropped AS lowest_dropped,
  scale.highest_dropped AS highest_dropped,
  judged.vectors AS calibration_vectors,
  judged.cells AS cells,
  judged.seen_once AS seen_once,
  judged.blocks AS blocks,
  judged.verdict AS verdict,
  judged.floor AS floor,
  judged.floor_sd AS floor_sd,
  judged.floor_max AS floor_max,
  judged.finest_bins AS finest_bins,
  judged.vectors_needed AS vectors_needed,
  judged.usual_low AS usual_low,
  judged.usual_middle AS usual_middle,
  judged.usual_high AS usual_high,
  judged.sees AS sees,
  judged.sees_half_stroke AS sees_half_stroke,
  judged.sees_frozen AS sees_frozen,
  judged.sees_faster AS sees_faster,
  judged.sees_slower AS sees_slower,
  judged.would_not_see AS would_not_see,
  judged.blind_reason AS blind_reason
FROM bounds AS scale
JOIN certified AS judged ON judged.channel_id = scale.channel_id
JOIN numbering AS numbered ON numbered.channel_id = scale.channel_id
WHERE scale.channel_id = scale.support_id
