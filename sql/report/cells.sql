-- Cells: the states of the signals that are shown which are visited most, healthy and novel, on their first axes.
-- Reads:  stored_cell
-- A row:  one axis of one cell; times are integers. visit_rank is 1 for the most visited one of a signal and kind;
--         cells and total count all of them, and their visits.
-- Slots:  :chosen  which versions are wanted
--         :most    cells of each signal and kind
--         :axes    axes of each cell
SELECT
  version_id,
  kind,
  visit_rank,
  cells,
  total,
  visits,
  first_tick,
  axis,
  code,
  place,
  value_from,
  value_to,
  program
FROM (
  SELECT
    version_id,
    kind,
    visits,
    first_tick,
    axis,
    code,
    place,
    value_from,
    value_to,
    program,
    CAST(COUNT(*) OVER (PARTITION BY version_id, kind, axis) AS BIGINT) AS cells,
    CAST(SUM(support_cell.visits) OVER (PARTITION BY version_id, kind, axis) AS BIGINT) AS total,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY version_id, kind, axis ORDER BY visits DESC, cell_key) AS BIGINT
    ) AS visit_rank
  FROM stored_cell AS support_cell
  WHERE :chosen AND axis < :axes
) AS ranked
WHERE visit_rank <= :most
ORDER BY version_id, kind, visit_rank, axis
