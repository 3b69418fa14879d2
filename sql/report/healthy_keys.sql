-- Healthy keys: the cells that healthy operation of one signal visited, to tell which readings of a piece are new.
-- Reads:  stored_support
-- A row:  one cell.
-- Slots:  :support_id  what was learnt
SELECT cell_key
FROM stored_support
WHERE support_id = :support_id
