-- Run, changed: whether rows of earlier runs may still be there that it hides. An engine with transactions deletes them
-- in the commit of the run, and none can come later: which run hides a bucket is then not asked of the runs of all
-- years. Runs that are there get 0 where no row of their version is hidden.
ALTER TABLE stored_run ADD COLUMN IF NOT EXISTS hides BIGINT;

UPDATE stored_run AS kept
SET hides = COALESCE(kept.hides, found.hides)
FROM (
  SELECT run.version_id AS version_id, run.run_id AS run_id, CAST(0 AS BIGINT) AS hides
  FROM stored_run AS run
  LEFT JOIN (
    SELECT version_id, 1 AS hit
    FROM (
      SELECT version_id, 1 AS written, 0 AS seen
      FROM stored_bucket
      UNION ALL
      SELECT version_id, 1 AS written, 0 AS seen
      FROM stored_novel
      UNION ALL
      SELECT version_id, 1 AS written, 0 AS seen
      FROM stored_judgement
      UNION ALL
      SELECT version_id, 0 AS written, 1 AS seen
      FROM stored_visible_bucket
      UNION ALL
      SELECT version_id, 0 AS written, 1 AS seen
      FROM stored_visible_novel
      UNION ALL
      SELECT version_id, 0 AS written, 1 AS seen
      FROM stored_visible_judgement
    ) AS all_rows
    GROUP BY version_id
    HAVING SUM(all_rows.written) <> SUM(all_rows.seen)
  ) AS hidden ON hidden.version_id = run.version_id
  WHERE CASE WHEN hidden.hit = 1 THEN 0 ELSE 1 END = 1
  GROUP BY run.version_id, run.run_id
) AS found
WHERE kept.version_id = found.version_id AND kept.run_id = found.run_id;

COMMENT ON COLUMN stored_run.hides
  IS '0 if no row of an earlier run is left that it hides; NULL where there may be';
