-- Ranged: the range of calibration without the few samples that lie far from the rest.
-- Reads:  calibrated, rounds
SELECT
  seen.asset AS asset,
  seen.channel AS channel,
  CASE WHEN final_range.hit = 1 THEN final_range.lo END AS lowest,
  CASE WHEN final_range.hit = 1 THEN final_range.hi END AS highest,
  seen.calibration_samples AS calibration_samples,
  CASE WHEN final_range.hit = 1 THEN final_range.dropped_below ELSE 0 END AS dropped_below,
  CASE WHEN final_range.hit = 1 THEN final_range.dropped_above ELSE 0 END AS dropped_above,
  CASE WHEN final_range.hit = 1 AND final_range.dropped_below > 0 THEN final_range.lowest END AS lowest_dropped,
  CASE WHEN final_range.hit = 1 AND final_range.dropped_above > 0 THEN final_range.highest END AS highest_dropped
FROM calibrated AS seen
LEFT JOIN (
  SELECT
    asset,
    channel,
    MAX(part.lo) AS lo,
    MIN(part.hi) AS hi,
    CAST(SUM(part.dropped_below) AS BIGINT) AS dropped_below,
    CAST(SUM(part.dropped_above) AS BIGINT) AS dropped_above,
    MIN(part.lo) AS lowest,
    MAX(part.hi) AS highest,
    1 AS hit
  FROM rounds AS part
  GROUP BY asset, channel
) AS final_range ON final_range.asset = seen.asset AND final_range.channel = seen.channel
