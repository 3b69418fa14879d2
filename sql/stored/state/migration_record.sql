-- Migration record: that a migration was applied, unless it is recorded already.
-- Reads:  stored_migration
-- A row:  one migration, or none.
-- Slots:  :number, :name  of the migration
--         :checksum  of its file
--         :applied_at  in microseconds
--         :gam_version  the gam-db that applied it
SELECT
  CAST(:number AS BIGINT) AS number,
  :name AS name,
  :checksum AS checksum,
  CAST(:applied_at AS BIGINT) AS applied_at,
  :gam_version AS gam_version
FROM (
  SELECT CAST(COUNT(*) AS BIGINT) AS records
  FROM stored_migration AS earlier
  WHERE earlier.number = :number
) AS recorded
WHERE records = 0
