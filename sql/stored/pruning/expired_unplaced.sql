-- Expired unplaced: the counts of rows without a place that runs of long ago left.
-- Reads:  stored_unplaced, stored_monitor
-- A row:  one run, by its key.
-- Slots:  :monitor        its name
--         :unplaced_from  runs that began from this instant on stay
SELECT
  run.monitor_id AS monitor_id,
  run.started AS started
FROM stored_unplaced AS run
JOIN stored_monitor AS watching ON watching.monitor_id = run.monitor_id
WHERE watching.name = :monitor AND run.started < :unplaced_from
