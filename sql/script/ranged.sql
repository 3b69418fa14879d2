-- Ranged: the range of calibration without the few samples that lie far from the rest.
-- Reads:  calibrated, rounds
SELECT
  seen.asset AS asset,
  seen.channel AS channel,
  CASE WHEN kept.hit = 1 THEN kept.lo END AS lowest,
  CASE WHEN kept.hit = 1 THEN kept.hi END AS highest,
  seen.calibration_samples AS calibration_samples,
  CASE WHEN kept.hit = 1 THEN kept.dropped_below ELSE 0 END AS dropped_below,
  CASE WHEN kept.hit = 1 THEN kept.dropped_above ELSE 0 END AS dropped_above,
  CASE WHEN kept.hit = 1 AND kept.dropped_below > 0 THEN kept.lowest END AS lowest_dropped,
  CASE WHEN kept.hit = 1 AND kept.dropped_above > 0 THEN kept.highest END AS highest_dropped
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
) AS kept ON kept.asset = seen.asset AND kept.channel = seen.channel
