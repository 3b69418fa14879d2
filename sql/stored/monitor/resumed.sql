-- Resumed: parked versions that have a value that was not read.
-- Reads:  readings, parted, plan
-- A row:  one version.
SELECT parked.version_id AS version_id
FROM readings AS reading
JOIN plan AS frozen ON frozen.asset = reading.asset AND frozen.channel = reading.channel
JOIN parted AS parked ON parked.version_id = frozen.version_id
WHERE parked.part_no = 0
  AND reading.time >= parked.look
  AND reading.reading BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE)
GROUP BY parked.version_id
