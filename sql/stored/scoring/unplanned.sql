-- Unplanned: versions of which something else is there by now than the run was planned from: another newest run, a
-- newer version of the channel, or other rows of runs. Somebody else has scored, calibrated or pruned meanwhile.
-- Reads:  cohort, newest_runs
-- A row:  one such version; newest_run is 0 where none has finished.
-- Slots:  :rows_differ  a condition on member and there: other rows of runs count
SELECT
  member.version_id AS version_id,
  CASE WHEN there.hit = 1 THEN there.newest_run ELSE CAST(0 AS BIGINT) END AS newest_run
FROM cohort AS member
LEFT JOIN (
  SELECT version_id, newest_run, run_rows, 1 AS hit
  FROM newest_runs
) AS there ON there.version_id = member.version_id
WHERE CASE
  WHEN there.hit = 1
    THEN CASE WHEN there.newest_run <> member.planned_from OR :rows_differ THEN 1 ELSE 0 END
  ELSE 1
END = 1
