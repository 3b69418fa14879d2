-- Expired versions: the versions that go altogether.
-- Reads:  pruned_versions
-- A row:  one version, by its key.
SELECT version_id
FROM pruned_versions
WHERE goes = 1
