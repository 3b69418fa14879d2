-- Recounted: the versions whose calibration is counted anew.
-- Reads:  counted
-- A row:  one version.
SELECT part.version_id AS version_id, part.channel_id AS channel_id, part.asset AS asset, part.channel AS channel
FROM counted AS part
WHERE part.recounted = 1
