-- Event rows: changes of the episodes of a monitor, in order.
-- Reads:  stored_alarm_event
-- A row:  one change; is_message is 1 for those that an incident is told by.
-- Slots:  :monitor  its name
--         :after    the last seq that is known already
SELECT
  seq,
  episode_id,
  what,
  noticed_at,
  asset,
  channel,
  status,
  is_proving,
  basis,
  incident_id,
  signals_together,
  is_message
FROM stored_alarm_event
WHERE monitor = :monitor AND seq > :after
ORDER BY seq
