-- Held vectors: the vectors of whole channels, where those of calibration and the scored ones are kept: a vector is
-- where its newest sample lies.
-- Reads:  calibration_vectors, incomplete_vectors, scale
-- A row:  one vector.
SELECT channel_id, cell_key
FROM calibration_vectors
UNION ALL
SELECT vector.channel_id AS channel_id, vector.cell_key AS cell_key
FROM incomplete_vectors AS vector
JOIN scale AS edge ON edge.channel_id = vector.channel_id
WHERE vector.time >= edge.first_scored
