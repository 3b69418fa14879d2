-- Healthy cells: the states that healthy operation of one signal visited.
-- Reads:  stored_support
-- A row:  one cell.
-- Slots:  :support_id  what was learnt
SELECT cell_key, visits, first_time, last_time
FROM stored_support
WHERE support_id = :support_id
ORDER BY visits DESC, cell_key
