-- Support summary: what was learnt of each channel, and whether it is good enough to be watched
-- (method, section 5).
-- Reads:  channels, series, bounds, blocks, limited, missing_vectors
-- A row:  one channel, in order. What speaks of the support is the pool's.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  scale.calibrated_lo AS calibrated_lo,
  scale.calibrated_hi AS calibrated_hi,
  scale.dropped_below AS dropped_below,
  scale.dropped_above AS dropped_above,
  scale.lowest_dropped AS lowest_dropped,
  scale.highest_dropped AS highest_dropped,
  CAST(extent.samples AS BIGINT) AS samples,
  CAST(scale.calibration_samples AS BIGINT) AS calibration_samples,
  CAST(CASE WHEN channel_blocks.hit = 1 THEN channel_blocks.vectors ELSE 0 END AS BIGINT) AS calibration_vectors,
  learnt.cells AS cells,
  CAST(CASE WHEN incomplete.hit = 1 THEN incomplete.missing_vectors ELSE 0 END AS BIGINT)
    AS missing_vectors,
  CAST(extent.conflicts AS BIGINT) AS conflicts,
  learnt.verdict AS verdict,
  learnt.floor AS floor,
  learnt.floor_sd AS floor_sd,
  learnt.floor_max AS floor_max,
  CASE
    WHEN learnt.vectors > 0 THEN CAST(learnt.seen_once AS DOUBLE) / CAST(learnt.vectors AS DOUBLE)
  END AS good_turing,
  CASE
    WHEN learnt.vectors > 0 THEN CAST(learnt.cells AS DOUBLE) / CAST(learnt.vectors AS DOUBLE)
  END AS cells_per_vector,
  learnt.blocks AS blocks,
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
  learnt.hi_limit AS hi_limit,
  learnt.limit_reason AS limit_reason
FROM channels AS named
JOIN series AS extent ON extent.channel_id = named.channel_id
JOIN bounds AS scale ON scale.channel_id = named.channel_id
JOIN limited AS learnt ON learnt.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, CAST(SUM(part.vectors) AS BIGINT) AS vectors, 1 AS hit
  FROM blocks AS part
  GROUP BY channel_id
) AS channel_blocks ON channel_blocks.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, missing_vectors, 1 AS hit
  FROM missing_vectors
) AS incomplete ON incomplete.channel_id = named.channel_id
ORDER BY named.asset, named.channel
