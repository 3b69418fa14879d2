-- Run, changed: how many buckets it wrote that are still there. Not of gam-db: tests/stored/test_upgrade.py
-- applies it after the last migration, so that a column is added and filled from the buckets.
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS buckets BIGINT;
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS novel BIGINT;

UPDATE stored_run AS kept
SET buckets = COALESCE(kept.buckets, found.buckets), novel = COALESCE(kept.novel, found.novel)
FROM (
  SELECT
    run_id,
    version_id,
    COUNT(*) AS buckets,
    CAST(SUM(novel) AS BIGINT) AS novel
  FROM stored_bucket
  GROUP BY run_id, version_id
) AS found
WHERE kept.run_id = found.run_id AND kept.version_id = found.version_id;

COMMENT ON COLUMN stored_run.buckets IS 'Buckets that it wrote and that are still there';
COMMENT ON COLUMN stored_run.novel IS 'Novel vectors in them';
