-- Left out, rows: the channels of which the newest run left rows out, or of which no calibration knows.
-- Reads:  stored_left_out, stored_unplaced
-- A row:  one channel and kind (ahead, unknown); affected: its rows; until: the latest of their times, an integer.
-- Slots:  :monitor_id
SELECT
  gone.kind AS kind,
  gone.asset AS asset,
  gone.channel AS channel,
  gone.readings AS affected,
  gone.latest AS until,
  gone.started AS started
FROM stored_left_out AS gone
JOIN (
  SELECT run.monitor_id AS monitor_id, MAX(run.started) AS started
  FROM stored_unplaced AS run
  WHERE run.monitor_id = :monitor_id
  GROUP BY run.monitor_id
) AS newest ON newest.monitor_id = gone.monitor_id AND newest.started = gone.started
