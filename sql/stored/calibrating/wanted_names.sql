-- Wanted names: the part of the source that is calibrated at once.
-- Reads:  names, wanted
-- A row:  one (asset, channel) pair.
SELECT
  source_name.asset AS asset,
  source_name.channel AS channel,
  source_name.readings AS readings,
  source_name.without_time AS without_time,
  source_name.missing_readings AS missing_readings,
  source_name.earliest AS earliest,
  source_name.latest AS latest
FROM names AS source_name
JOIN wanted AS want ON want.asset = source_name.asset AND want.channel = source_name.channel
