-- Ladder: what healthy operation of the signals that are shown would seem to be on coarser grids.
-- Reads:  stored_ladder
-- A row:  one grid of one support.
-- Slots:  :chosen  which supports are wanted
SELECT support_id, bins, floor
FROM stored_ladder
WHERE :chosen
ORDER BY support_id, bins DESC
