-- Support, stored form: the cells of the supports that the group of channels needs.
-- Reads:  stored_support, cohort
-- A row:  one cell of one support.
SELECT cell.support_id AS support_id, cell.cell_key AS cell_key
FROM stored_support AS cell
JOIN (
  SELECT support_id
  FROM cohort
  GROUP BY support_id
) AS needed ON needed.support_id = cell.support_id
