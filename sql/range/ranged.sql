-- Ranged: the calibration samples of each channel with the range that the rounds leave of its support, in the place of
-- the range of all of them.
-- Reads:  calibrated, channels, rounds
-- A row:  one channel that has at least one calibration sample. lowest_dropped is the least value below the range,
--         highest_dropped the greatest one above it; NULL where nothing was dropped there.
-- Slots:  :settings_no  the set of parameters that this step serves
SELECT
  seen.channel_id AS channel_id,
  CASE WHEN final_range.hit = 1 THEN final_range.lo END AS lowest,
  CASE WHEN final_range.hit = 1 THEN final_range.hi END AS highest,
  seen.calibration_samples AS calibration_samples,
  CASE WHEN final_range.hit = 1 THEN final_range.dropped_below ELSE 0 END AS dropped_below,
  CASE WHEN final_range.hit = 1 THEN final_range.dropped_above ELSE 0 END AS dropped_above,
  CASE WHEN final_range.hit = 1 AND final_range.dropped_below > 0 THEN final_range.lowest END AS lowest_dropped,
  CASE WHEN final_range.hit = 1 AND final_range.dropped_above > 0 THEN final_range.highest END AS highest_dropped
FROM calibrated AS seen
JOIN channels AS named ON named.channel_id = seen.channel_id
LEFT JOIN (
  SELECT
    support_id,
    MAX(part.lo) AS lo,
    MIN(part.hi) AS hi,
    CAST(SUM(part.dropped_below) AS BIGINT) AS dropped_below,
    CAST(SUM(part.dropped_above) AS BIGINT) AS dropped_above,
    MIN(part.lo) AS lowest,
    MAX(part.hi) AS highest,
    1 AS hit
  FROM rounds AS part
  GROUP BY support_id
) AS final_range ON final_range.support_id = named.support_id
WHERE named.settings_no = :settings_no
