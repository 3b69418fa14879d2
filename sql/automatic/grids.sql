-- Grids: the cells on every grid that is compared, the finest one (level 0) and those made of it.
-- Reads:  cells, coarsened
-- A row:  one cell of one support on one grid.
SELECT support_id, 0 AS level, cell_key, visits, first_block, last_block
FROM cells
UNION ALL
SELECT support_id, level, cell_key, visits, first_block, last_block
FROM coarsened
