-- Frozen: the wanted versions as they are stored, with all integers that calibration froze.
-- Reads:  stored_version, wanted
-- A row:  one version.
-- Slots:  :figures  these integers
SELECT
  made.version_id AS version_id,
  made.support_id AS support_id,
  made.target_floor AS target_floor,
  made.settings_hash AS settings_hash,
  made.method_hash AS method_hash,
  :figures
FROM stored_version AS made
JOIN (
  SELECT version_id
  FROM wanted
  GROUP BY version_id
) AS asked ON asked.version_id = made.version_id
