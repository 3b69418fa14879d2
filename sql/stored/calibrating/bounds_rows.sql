-- Bounds rows: range and certificate of each new support; members of a pool share theirs.
-- Reads:  bounds, certified, numbering
-- A row:  one support; member_... is the certificate of members that taught nothing, NULL where there are none, but for
--         member_floor, which is there where two taught.
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
  judged.blind_reason AS blind_reason,
  CASE WHEN others.hit = 1 THEN others.vouched_by END AS teachers,
  judged.taught_by AS taught_by,
  CASE WHEN others.hit = 1 THEN others.verdict END AS member_verdict,
  judged.member_floor AS member_floor,
  CASE WHEN others.hit = 1 THEN others.floor_sd END AS member_floor_sd,
  CASE WHEN others.hit = 1 THEN others.floor_max END AS member_floor_max,
  CASE WHEN others.hit = 1 THEN others.finest_bins END AS member_finest_bins
FROM (
  SELECT
    scale.support_id AS support_id,
    MIN(CASE WHEN judged.vouched_by IS NULL THEN scale.channel_id END) AS teacher,
    MIN(CASE WHEN judged.vouched_by IS NOT NULL THEN scale.channel_id END) AS other
  FROM bounds AS scale
  JOIN certified AS judged ON judged.channel_id = scale.channel_id
  GROUP BY scale.support_id
) AS pool
JOIN bounds AS scale ON scale.channel_id = pool.teacher
JOIN certified AS judged ON judged.channel_id = pool.teacher
JOIN numbering AS numbered ON numbered.channel_id = pool.teacher
LEFT JOIN (
  SELECT
    channel_id,
    vouched_by,
    verdict,
    floor_sd,
    floor_max,
    finest_bins,
    1 AS hit
  FROM certified
) AS others ON others.channel_id = pool.other
