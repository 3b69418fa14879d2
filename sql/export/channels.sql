-- Channels, dbt form: as the package froze them; numbers and limits are looked up here, too.
-- Reads:  stored_channel
-- A row:  one channel.
SELECT
  known.channel_id AS channel_id,
  known.channel_id AS stored_channel_id,
  known.support_id AS support_id,
  known.support_id AS stored_support_id,
  known.asset AS asset,
  known.channel AS channel,
  0 AS settings_no,
  known.calibration_no AS calibration_no,
  known.calibration_end AS calibration_end,
  known.first_scored AS first_scored
FROM stored_channel AS known
