-- Stamp of a scheduled run: its number and its times, under the lock of its monitor. A later run has a larger number;
-- by its last digits runs of two monitors differ.
-- Reads:  clock, stored_run
-- A row:  the only one.
-- Slots:  :now         this instant, in microseconds since 1970 (UTC)
--         :monitor_id
SELECT
  CASE WHEN newest.run_id >= watch.started * 1024 THEN newest.run_id + 1 ELSE watch.started * 1024 END
    + CAST(:monitor_id AS BIGINT) % 1024 AS run_id,
  watch.started AS started,
  CAST(:now AS BIGINT) AS committed,
  CAST(1 AS BIGINT) AS deletes_hidden,
  CAST(1 AS BIGINT) AS episodes_pending
FROM clock AS watch
CROSS JOIN (
  SELECT COALESCE(MAX(run.run_id), 0) AS run_id
  FROM stored_run AS run
) AS newest
