-- Limits, dbt form: when the calibration of each channel ends, and from when on it is scored (method, section 4).
-- Reads:  channels, rules
-- A row:  one channel; calibration_end is NULL where it has no calibration of its own.
-- Slots:  :long_ago  an instant before all others
SELECT
  named.channel_id AS channel_id,
  healthy.declared_end AS calibration_end,
  CASE
    WHEN healthy.score_from IS NOT NULL THEN healthy.score_from
    WHEN healthy.declared_end IS NOT NULL THEN healthy.declared_end + 1
    ELSE CAST(:long_ago AS BIGINT)
  END AS first_scored
FROM channels AS named
JOIN rules AS healthy ON healthy.calibration_no = named.calibration_no
