-- Certified, dbt form: what calibration says of each channel.
-- Reads:  stored_channel, stored_bounds
-- A row:  one channel.
SELECT
  channel_row.channel_id AS channel_id,
  learnt.verdict AS verdict,
  learnt.floor AS floor,
  learnt.floor_sd AS floor_sd,
  learnt.floor_max AS floor_max,
  learnt.finest_bins AS finest_bins,
  learnt.vectors_needed AS vectors_needed,
  learnt.calibration_vectors AS calibration_vectors,
  learnt.cells AS cells,
  learnt.calibrated_lo AS calibrated_lo,
  learnt.calibrated_hi AS calibrated_hi,
  learnt.sees AS sees,
  learnt.sees_half_stroke AS sees_half_stroke,
  learnt.sees_frozen AS sees_frozen,
  learnt.sees_faster AS sees_faster,
  learnt.sees_slower AS sees_slower,
  learnt.would_not_see AS would_not_see,
  learnt.blind_reason AS blind_reason,
  learnt.teachers AS vouched_by,
  learnt.taught_by AS taught_by,
  learnt.member_floor AS member_floor
FROM stored_channel AS channel_row
JOIN stored_bounds AS learnt ON learnt.support_id = channel_row.support_id
