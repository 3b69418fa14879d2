-- Support bits: the cells of a support as one row of bits, one for each cell of the grid. Asking for a bit
-- costs less than looking a cell up, however many cells there are.
-- Reads:  support
-- A row:  one support.
-- Slots:  :bits  cell_key, gathered
SELECT support_id, :bits AS bits
FROM support
GROUP BY support_id
