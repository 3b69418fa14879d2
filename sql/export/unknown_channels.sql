-- Unknown channels: those that have rows at the time of calibration, and had none when the package was first
-- built. They are scored after a full refresh.
-- Reads:  names, stored_channel
-- A row:  one such channel.
SELECT
  found.asset AS asset,
  found.channel AS channel,
  found.readings AS readings
FROM names AS found
LEFT JOIN (
  SELECT asset, channel, 1 AS hit
  FROM stored_channel
) AS known ON known.asset = found.asset AND known.channel = found.channel
WHERE found.readings > 0
  AND found.asset IS NOT NULL
  AND found.channel IS NOT NULL
  AND CASE WHEN known.hit = 1 THEN 0 ELSE 1 END = 1
