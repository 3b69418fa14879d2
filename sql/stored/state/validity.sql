-- Validity: how many readings the newest run that read any held to the condition of its source (valid_when), and for how
-- many of them it does not hold.
-- Reads:  stored_unplaced, stored_monitor
-- A row:  the newest such run of the monitor; none where its source has no such condition.
-- Slots:  :monitor  the name of the monitor
SELECT
  MAX(run.held) AS held,
  MAX(run.invalid) AS invalid
FROM stored_unplaced AS run
JOIN (
  SELECT earlier.monitor_id AS monitor_id, MAX(earlier.started) AS started
  FROM stored_unplaced AS earlier
  JOIN stored_monitor AS watching ON watching.monitor_id = earlier.monitor_id
  WHERE watching.name = :monitor AND earlier.held > 0
  GROUP BY earlier.monitor_id
) AS newest ON newest.monitor_id = run.monitor_id AND newest.started = run.started
GROUP BY run.monitor_id
