-- Vouched, dbt form: what calibration says of each channel where there are pools: of a member that taught nothing what the
-- others say of it (both sides, section 6).
-- Reads:  stored_channel, stored_bounds, stored_block
-- A row:  one channel.
SELECT
  channel_row.channel_id AS channel_id,
  CASE WHEN others.hit = 1 THEN learnt.member_verdict ELSE learnt.verdict END AS verdict,
  CASE WHEN others.hit = 1 THEN learnt.member_floor ELSE learnt.floor END AS floor,
  CASE WHEN others.hit = 1 THEN learnt.member_floor_sd ELSE learnt.floor_sd END AS floor_sd,
  CASE WHEN others.hit = 1 THEN learnt.member_floor_max ELSE learnt.floor_max END AS floor_max,
  CASE WHEN others.hit = 1 THEN learnt.member_finest_bins ELSE learnt.finest_bins END AS finest_bins,
  CASE
    WHEN others.hit = 1 AND learnt.member_verdict <> 'ready' AND learnt.member_verdict <> 'blind' THEN NULL
    WHEN others.hit = 1 THEN 0
    ELSE learnt.vectors_needed
  END AS vectors_needed,
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
  CASE WHEN others.hit = 1 THEN learnt.teachers END AS vouched_by,
  learnt.taught_by AS taught_by,
  learnt.member_floor AS member_floor
FROM stored_channel AS channel_row
JOIN stored_bounds AS learnt ON learnt.support_id = channel_row.support_id
LEFT JOIN (
  SELECT member.channel_id AS channel_id, 1 AS hit
  FROM stored_channel AS member
  JOIN stored_bounds AS pool ON pool.support_id = member.support_id
  LEFT JOIN (
    SELECT support_id, channel_id, 1 AS hit
    FROM stored_block
    GROUP BY support_id, channel_id
  ) AS taught ON taught.support_id = member.support_id AND taught.channel_id = member.channel_id
  WHERE pool.member_verdict IS NOT NULL AND CASE WHEN taught.hit = 1 THEN 1 ELSE 0 END < 1
) AS others ON others.channel_id = channel_row.channel_id
