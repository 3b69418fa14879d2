-- Rivals: what a committed run did not know when it was planned: another finished run that was planned from the same
-- one; that one being withdrawn or pruned; or a newer version. A run that was planned from this one is no rival.
-- Reads:  cohort, stored_finished_run, stored_version
-- A row:  one version of the cohort with a rival; rival is its number, 0 where it is no run that could still give way.
-- Slots:  :run_id  of the committed run
--         :near    a condition on run that holds for all runs that may matter
--         :among   a condition on version, which channels are asked for
SELECT
  member.version_id AS version_id,
  CASE WHEN other.hit = 1 THEN other.rival ELSE CAST(0 AS BIGINT) END AS rival
FROM cohort AS member
LEFT JOIN (
  SELECT run.version_id AS version_id, run.planned_from AS planned_from, MIN(run.run_id) AS rival, 1 AS hit
  FROM stored_finished_run AS run
  WHERE run.run_id <> :run_id AND :near
  GROUP BY run.version_id, run.planned_from
) AS other ON other.version_id = member.version_id AND other.planned_from = member.planned_from
LEFT JOIN (
  SELECT run.version_id AS version_id, run.run_id AS run_id, 1 AS hit
  FROM stored_finished_run AS run
  WHERE :near
) AS former ON former.version_id = member.version_id AND former.run_id = member.planned_from
LEFT JOIN (
  SELECT version.channel_id AS channel_id, MAX(version.version_id) AS version_id, 1 AS hit
  FROM stored_version AS version
  WHERE :among
  GROUP BY version.channel_id
) AS newest ON newest.channel_id = member.channel_id
WHERE other.hit = 1
  OR (member.planned_from > 0 AND CASE WHEN former.hit = 1 THEN 0 ELSE 1 END = 1)
  OR CASE
    WHEN newest.hit = 1 THEN CASE WHEN newest.version_id <> member.version_id THEN 1 ELSE 0 END
    ELSE 1
  END = 1
