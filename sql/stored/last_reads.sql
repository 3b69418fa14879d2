-- Last reads: when each version was last read, how far, and when its calibration was last counted anew. The newest
-- run says when: one that was made while the clock stood ahead says so only until the next.
-- Reads:  stored_finished_run, active
-- A row:  one version that was ever read.
-- Slots:  :long_ago  an instant before all others
SELECT
  version_id,
  MAX(CASE WHEN looked.read_to IS NOT NULL THEN looked.read_to ELSE CAST(:long_ago AS BIGINT) END)
    AS read_until,
  MAX(CASE WHEN run_id = newest_id THEN committed END) AS looked_at,
  MAX(CASE WHEN run_id = counting_id THEN committed ELSE CAST(:long_ago AS BIGINT) END) AS counted_at
FROM (
  SELECT
    run.version_id AS version_id,
    run.run_id AS run_id,
    run.read_to AS read_to,
    run.committed AS committed,
    MAX(run.run_id) OVER (PARTITION BY run.version_id) AS newest_id,
    MAX(CASE WHEN run.calibration_readings IS NOT NULL THEN run.run_id END)
      OVER (PARTITION BY run.version_id) AS counting_id
  FROM stored_finished_run AS run
  JOIN active AS frozen ON frozen.version_id = run.version_id
) AS looked
GROUP BY version_id
