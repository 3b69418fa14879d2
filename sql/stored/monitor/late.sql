-- Late: versions of which nothing was found where their context begins. Rows may have left the source.
-- Reads:  wanted, readings
-- A row:  one version; oldest_time is that of its first row.
SELECT
  part.version_id AS version_id,
  part.asset AS asset,
  part.channel AS channel,
  part.read_from AS read_from,
  there.oldest_time AS oldest_time
FROM wanted AS part
JOIN (
  SELECT channel_id, MIN(reading.time) AS oldest_time
  FROM readings AS reading
  GROUP BY channel_id
) AS there ON there.channel_id = part.channel_id
WHERE part.restarts = 1 AND there.oldest_time > part.read_from
