-- Newest runs: what a run is planned from: the newest finished run of each active version, and how many rows its
-- runs have, withdrawn ones too. Where both are as they were, nothing came or went meanwhile.
-- Reads:  stored_version, stored_run, stored_finished_run
-- A row:  one active version; newest_run is 0 where none has finished.
-- Slots:  :among  a condition on version, which channels are asked for
--         :near   a condition on run that holds for all runs that may matter
SELECT
  active.version_id AS version_id,
  CASE WHEN done.hit = 1 THEN done.newest_run ELSE CAST(0 AS BIGINT) END AS newest_run,
  CASE WHEN held.hit = 1 THEN held.run_rows ELSE CAST(0 AS BIGINT) END AS run_rows
FROM (
  SELECT version.channel_id AS channel_id, MAX(version.version_id) AS version_id
  FROM stored_version AS version
  WHERE :among
  GROUP BY version.channel_id
) AS active
LEFT JOIN (
  SELECT run.version_id AS version_id, MAX(run.run_id) AS newest_run, 1 AS hit
  FROM stored_finished_run AS run
  WHERE :near
  GROUP BY run.version_id
) AS done ON done.version_id = active.version_id
LEFT JOIN (
  SELECT run.version_id AS version_id, CAST(COUNT(*) AS BIGINT) AS run_rows, 1 AS hit
  FROM stored_run AS run
  WHERE :near
  GROUP BY run.version_id
) AS held ON held.version_id = active.version_id
