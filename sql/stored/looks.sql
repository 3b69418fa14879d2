-- Looks: when each version was last read, how far, and when its calibration was last counted anew.
-- Reads:  stored_finished_run, active
-- A row:  one version that was ever read.
-- Slots:  :long_ago  an instant before all others
SELECT
  looked.version_id AS version_id,
  MAX(CASE WHEN looked.read_to IS NOT NULL THEN looked.read_to ELSE CAST(:long_ago AS BIGINT) END)
    AS read_until,
  MAX(looked.committed) AS looked_at,
  MAX(
    CASE
      WHEN looked.calibration_readings IS NOT NULL THEN looked.committed
      ELSE CAST(:long_ago AS BIGINT)
    END
  ) AS counted_at
FROM stored_finished_run AS looked
JOIN active AS frozen ON frozen.version_id = looked.version_id
GROUP BY looked.version_id
