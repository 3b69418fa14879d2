-- Expired supports: what was learnt for versions that go, where no version that stays shares it.
-- Reads:  pruned_versions, stored_version
-- A row:  one support, by its key.
SELECT DISTINCT pruned.support_id AS support_id
FROM pruned_versions AS pruned
LEFT JOIN (
  SELECT DISTINCT
    version.support_id AS support_id,
    1 AS hit
  FROM stored_version AS version
  LEFT JOIN (
    SELECT version_id, 1 AS hit
    FROM pruned_versions
    WHERE goes = 1
  ) AS going ON going.version_id = version.version_id
  WHERE CASE WHEN going.hit = 1 THEN 0 ELSE 1 END = 1
) AS staying ON staying.support_id = pruned.support_id
WHERE CASE WHEN staying.hit = 1 THEN 0 ELSE 1 END = 1
