-- Channels, dbt form: as the package froze them; numbers and limits are looked up here, too.
-- Reads:  stored_channel
-- A row:  one channel.
SELECT
  channel_row.channel_id AS channel_id,
  channel_row.channel_id AS stored_channel_id,
  channel_row.support_id AS support_id,
  channel_row.support_id AS stored_support_id,
  channel_row.asset AS asset,
  channel_row.channel AS channel,
  0 AS settings_no,
  channel_row.calibration_no AS calibration_no,
  channel_row.calibration_end AS calibration_end,
  channel_row.first_scored AS first_scored
FROM stored_channel AS channel_row
