-- Time kinds: how the source of each monitor tells time.
-- Reads:  stored_monitor
-- A row:  one monitor, in order.
SELECT
  name,
  time_kind
FROM stored_monitor
ORDER BY name
