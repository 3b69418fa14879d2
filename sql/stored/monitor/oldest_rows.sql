-- Oldest rows: versions of which the source lost all rows before the oldest that it has.
-- Reads:  late, older
-- A row:  one version.
SELECT behind.version_id AS version_id, behind.oldest_time AS oldest_time
FROM late AS behind
LEFT JOIN (
  SELECT version_id, 1 AS hit
  FROM older
) AS held ON held.version_id = behind.version_id
WHERE CASE WHEN held.hit = 1 THEN 0 ELSE 1 END = 1
