-- Run, changed: what a run was planned from, and whether it was withdrawn. A run counts only if what it was
-- planned from was still there when it was recorded.
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS planned_from BIGINT;
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS withdrawn BIGINT;

COMMENT ON COLUMN stored_run.planned_from
  IS 'The newest finished run of the version when this one was planned; 0 if there was none';
COMMENT ON COLUMN stored_run.withdrawn
  IS 'In a second row of a run: 1, it gave way to another that was planned from the same; else NULL';
