-- Older: late versions that do have an older row: between it and the first one there is a hole, which is a correction.
-- Reads:  readings, late
-- A row:  one version.
SELECT behind.version_id AS version_id
FROM readings AS reading
JOIN late AS behind ON behind.asset = reading.asset AND behind.channel = reading.channel
WHERE reading.time < behind.read_from
GROUP BY behind.version_id
