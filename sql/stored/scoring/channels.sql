-- Channels, stored form: those of the group that is scored, by their stored numbers.
-- Reads:  cohort
-- A row:  one channel.
SELECT
  member.channel_id AS channel_id,
  member.support_id AS support_id,
  member.asset AS asset,
  member.channel AS channel,
  member.read_from AS read_from,
  member.read_until AS read_until,
  0 AS settings_no,
  0 AS calibration_no,
  CAST(0 AS BIGINT) AS readings
FROM cohort AS member
