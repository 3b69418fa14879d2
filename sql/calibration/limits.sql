-- Limits: when each channel's calibration begins and ends, and from when on it is scored
-- (method, section 4). The end is the declared one, even where no sample lies there.
-- Reads:  channels, series, rules
-- A row:  one channel; calibration_end is NULL where it has no calibration of its own, and then a
--         member of a pool is scored from its first sample.
-- Slots:  :long_ago  an instant before all others
SELECT
  resolved.channel_id AS channel_id,
  resolved.calibration_no AS calibration_no,
  resolved.calibration_from AS calibration_from,
  resolved.calibration_end AS calibration_end,
  CASE
    WHEN resolved.score_from IS NOT NULL THEN resolved.score_from
    WHEN resolved.calibration_end IS NOT NULL THEN resolved.calibration_end + 1
    ELSE CAST(:long_ago AS BIGINT)
  END AS first_scored
FROM (
  SELECT
    named.channel_id AS channel_id,
    named.calibration_no AS calibration_no,
    chosen_rule.score_from AS score_from,
    CASE
      WHEN chosen_rule.declared_end IS NULL THEN extent.first_time
      ELSE CAST(:long_ago AS BIGINT)
    END AS calibration_from,
    CASE
      WHEN chosen_rule.fraction IS NOT NULL THEN extent.quota_time
      WHEN chosen_rule.duration IS NOT NULL THEN extent.first_time + chosen_rule.duration
      ELSE chosen_rule.declared_end
    END AS calibration_end
  FROM channels AS named
  JOIN series AS extent ON extent.channel_id = named.channel_id
  JOIN rules AS chosen_rule ON chosen_rule.calibration_no = named.calibration_no
) AS resolved
