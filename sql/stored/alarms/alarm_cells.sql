-- Alarm cells: the commonest novel cells of an episode, with the healthy cell next to each.
-- Reads:  stored_alarm_cell
-- A row:  one cell on one axis, in order.
-- Slots:  :monitor  its name
--         :episode_id, :version_id
SELECT
  cell_rank,
  cell_key,
  visits,
  first_tick,
  last_tick,
  axis,
  samples_before,
  place,
  value_from,
  value_to,
  steps,
  displacement,
  program
FROM stored_alarm_cell
WHERE monitor = :monitor AND episode_id = :episode_id AND version_id = :version_id
ORDER BY cell_rank, axis
