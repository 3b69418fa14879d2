-- Channels: everything below is computed per (asset, channel) and speaks of it by an integer id
-- (method, section 1). The members of a pool share one support (method, section 4).
-- Reads:  names
-- A row:  one channel; rows without a name or a time belong to none.
-- Slots:  :settings_no     which set of parameters applies, 0 for the general one
--         :calibration_no  which rule of calibration applies, 0 for the general one
--         :pool_no         which pool the channel belongs to, 0 for none
SELECT
  named.channel_id AS channel_id,
  CASE
    WHEN named.pool_no = 0 THEN named.channel_id
    ELSE MIN(named.channel_id) OVER (PARTITION BY named.pool_no, named.settings_no, named.channel)
  END AS support_id,
  named.asset AS asset,
  named.channel AS channel,
  named.readings AS readings,
  named.missing_readings AS missing_readings,
  named.settings_no AS settings_no,
  named.calibration_no AS calibration_no
FROM (
  SELECT
    CAST(ROW_NUMBER() OVER (ORDER BY asset, channel) AS INTEGER) AS channel_id,
    asset,
    channel,
    readings,
    missing_readings,
    :settings_no AS settings_no,
    :calibration_no AS calibration_no,
    :pool_no AS pool_no
  FROM names
  WHERE asset IS NOT NULL AND channel IS NOT NULL AND readings > 0
) AS named
