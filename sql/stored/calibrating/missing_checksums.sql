-- Missing checksums: the versions that have no checksum yet.
-- Reads:  stored_version, stored_checksum
-- A row:  one version.
SELECT made.version_id AS version_id
FROM stored_version AS made
LEFT JOIN (
  SELECT version_id, 1 AS hit
  FROM stored_checksum
  GROUP BY version_id
) AS summed ON summed.version_id = made.version_id
WHERE CASE WHEN summed.hit = 1 THEN 0 ELSE 1 END = 1
