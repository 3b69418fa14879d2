-- Wanted names: the part of the source that is calibrated at once.
-- Reads:  names, wanted
-- A row:  one (asset, channel) pair.
SELECT
  found.asset AS asset,
  found.channel AS channel,
  found.readings AS readings,
  found.without_time AS without_time,
  found.missing_readings AS missing_readings,
  found.earliest AS earliest,
  found.latest AS latest
FROM names AS found
JOIN wanted AS asked ON asked.asset = found.asset AND asked.channel = found.channel
