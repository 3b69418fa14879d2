-- Unsettled: before the first round no reference vector has its neighbour.
-- Reads:  probes
-- A row:  one reference vector.
SELECT channel_id, place, 0 AS settled
FROM probes
