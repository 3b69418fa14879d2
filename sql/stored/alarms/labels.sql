-- Labels: what people said of a monitor's episodes and machines.
-- Reads:  stored_label
-- A row:  one label, in order.
-- Slots:  :monitor_id
SELECT
  label_id,
  episode_id,
  asset,
  time_from,
  time_to,
  kind,
  note,
  until,
  created
FROM stored_label
WHERE monitor_id = :monitor_id
ORDER BY label_id
