-- Unrecorded: versions that were read, but by no run that looked back as far as this one: their buckets are looked at.
-- Reads:  active, recorded, last_reads
-- A row:  one version.
-- Slots:  :long_ago  an instant before all others
SELECT
  frozen.version_id AS version_id,
  frozen.window_length AS window_length,
  frozen.stride AS stride
FROM active AS frozen
JOIN last_reads AS read ON read.version_id = frozen.version_id
LEFT JOIN (
  SELECT version_id, 1 AS hit
  FROM recorded
) AS staying ON staying.version_id = frozen.version_id
WHERE read.read_until > CAST(:long_ago AS BIGINT) AND CASE WHEN staying.hit = 1 THEN 0 ELSE 1 END = 1
