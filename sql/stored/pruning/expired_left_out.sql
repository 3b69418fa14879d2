-- Expired left out: the channels of which an earlier run left rows out; those of the newest run count.
-- Reads:  stored_left_out, stored_unplaced, stored_monitor
-- A row:  one run, by its key.
-- Slots:  :monitor  its name
SELECT DISTINCT
  gone.monitor_id AS monitor_id,
  gone.started AS started
FROM stored_left_out AS gone
JOIN (
  SELECT monitor_id, MAX(run.started) AS newest
  FROM stored_unplaced AS run
  GROUP BY monitor_id
) AS latest ON latest.monitor_id = gone.monitor_id
JOIN stored_monitor AS watching ON watching.monitor_id = gone.monitor_id
WHERE watching.name = :monitor AND gone.started < latest.newest
