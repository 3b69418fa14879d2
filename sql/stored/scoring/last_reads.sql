-- Last reads: when each version was last read, how far, and when its calibration was last counted anew. The newest
-- run says when, and the newest that read anything says how far: what an earlier one read may have gone since.
-- Reads:  stored_finished_run, active
-- A row:  one version that was ever read.
-- Slots:  :long_ago  an instant before all others
--         :since     the first run that is looked at
SELECT
  read.version_id AS version_id,
  MAX(CASE WHEN each_run.run_id = read.reading_id THEN each_run.read_to ELSE CAST(:long_ago AS BIGINT) END)
    AS read_until,
  MAX(CASE WHEN each_run.run_id = read.newest_id THEN each_run.committed END) AS looked_at,
  MAX(CASE WHEN each_run.run_id = read.counting_id THEN each_run.committed ELSE CAST(:long_ago AS BIGINT) END)
    AS counted_at
FROM (
  SELECT
    run.version_id AS version_id,
    MAX(CASE WHEN run.read_to IS NOT NULL THEN run.run_id ELSE -1 END) AS reading_id,
    MAX(run.run_id) AS newest_id,
    MAX(CASE WHEN run.calibration_readings IS NOT NULL THEN run.run_id ELSE -1 END) AS counting_id
  FROM stored_finished_run AS run
  JOIN active AS frozen ON frozen.version_id = run.version_id
  WHERE run.run_id >= :since
  GROUP BY run.version_id
) AS read
JOIN stored_finished_run AS each_run ON each_run.version_id = read.version_id
WHERE each_run.run_id >= :since
  AND (
    each_run.run_id = read.newest_id
    OR each_run.run_id = read.reading_id
    OR each_run.run_id = read.counting_id
  )
GROUP BY read.version_id
