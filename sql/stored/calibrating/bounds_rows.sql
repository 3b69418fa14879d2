-- Bounds rows: range and certificate of each new support; members of a pool share theirs.
-- Reads:  bounds, verdicts, usual, numbering
-- A row:  one support.
SELECT
  numbered.stored_support_id AS support_id,
  scale.calibrated_lo AS calibrated_lo,
  scale.calibrated_hi AS calibrated_hi,
  scale.dropped_below AS dropped_below,
  scale.dropped_above AS dropped_above,
  scale.lowest_dropped AS lowest_dropped,
  scale.highest_dropped AS highest_dropped,
  CASE WHEN probed.hit = 1 THEN probed.q05 END AS usual_low,
  CASE WHEN probed.hit = 1 THEN probed.q50 END AS usual_middle,
  CASE WHEN probed.hit = 1 THEN probed.q95 END AS usual_high,
  judged.vectors AS calibration_vectors,
  judged.cells AS cells,
  judged.seen_once AS seen_once,
  judged.blocks AS blocks,
  judged.verdict AS verdict,
  judged.floor AS floor,
  judged.floor_sd AS floor_sd,
  judged.floor_max AS floor_max,
  judged.finest_bins AS finest_bins,
  judged.vectors_needed AS vectors_needed
FROM bounds AS scale
JOIN verdicts AS judged ON judged.channel_id = scale.channel_id
JOIN numbering AS numbered ON numbered.channel_id = scale.channel_id
LEFT JOIN (
  SELECT support_id, q05, q50, q95, 1 AS hit
  FROM usual
) AS probed ON probed.support_id = scale.support_id
WHERE scale.channel_id = scale.support_id
