-- Support rows: the cells that healthy operation visits (Eq. 3), with what calibration knows of each.
-- Reads:  cells, numbering
-- A row:  one cell of one new support.
SELECT
  numbered.stored_support_id AS support_id,
  cell.cell_key AS cell_key,
  cell.visits AS visits,
  cell.first_block AS first_block,
  cell.last_block AS last_block,
  cell.first_time AS first_time,
  cell.last_time AS last_time
FROM cells AS cell
JOIN numbering AS numbered ON numbered.channel_id = cell.support_id
ORDER BY numbered.stored_support_id, cell.cell_key
