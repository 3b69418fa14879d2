-- Edge range: between which instants the slices lie that must be read sample by sample.
-- Reads:  edges
-- A row:  the only one, NULL where none must be read.
SELECT MIN(part.first_time) AS first_time, MAX(part.last_time) AS last_time
FROM edges AS part
WHERE part.is_edge = 1
