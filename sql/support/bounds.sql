-- Bounds: the ends of the calibrated range, by which samples are coded (lo and hi of method, section 3), one pair for all delays of a
-- channel and for all members of its pool; with them all that scoring must know of a channel.
-- Reads:  channels, limits, calibrated
-- A row:  one channel; the ends are NULL where calibration has no usable sample: nothing is scored.
-- Slots:  :settings_no  the set of parameters that this step serves
--         :dropped  what was left out of the range (range/dropped.sql), or that nothing was
--         :carried  the columns that say so of a channel
--         :bins, :window, :target_floor  B, W and the target of that set, for the steps that serve all sets at
--         once
SELECT
  named.channel_id AS channel_id,
  named.support_id AS support_id,
  MIN(CASE WHEN seen.hit = 1 THEN seen.lowest END) OVER (PARTITION BY named.support_id)
    AS calibrated_lo,
  MAX(CASE WHEN seen.hit = 1 THEN seen.highest END) OVER (PARTITION BY named.support_id)
    AS calibrated_hi,
  :dropped,
  CASE WHEN seen.hit = 1 THEN seen.calibration_samples ELSE 0 END AS calibration_samples,
  edge.calibration_end AS calibration_end,
  edge.first_scored AS first_scored,
  :bins AS bins,
  :window AS window_length,
  CAST(:target_floor AS DOUBLE) AS target_floor
FROM channels AS named
JOIN limits AS edge ON edge.channel_id = named.channel_id
LEFT JOIN (
  SELECT channel_id, lowest, highest, calibration_samples, :carried, 1 AS hit
  FROM calibrated
) AS seen ON seen.channel_id = named.channel_id
WHERE named.settings_no = :settings_no
