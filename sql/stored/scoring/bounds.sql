-- Bounds, stored form: frozen when the version was made; first_scored moves on to the first vector that
-- belongs to no bucket that stays.
-- Reads:  cohort
-- A row:  one channel.
-- Slots:  :settings  the settings of a channel that its steps read; none where all channels share them
SELECT
  member.channel_id AS channel_id,
  member.support_id AS support_id,
  member.lo AS calibrated_lo,
  member.hi AS calibrated_hi,
  member.calibration_end AS calibration_end,
  member.first_scored AS first_scored,
  :settings
FROM cohort AS member
