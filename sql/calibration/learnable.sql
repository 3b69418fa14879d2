-- Learnable: the vectors that calibration teaches: every sample from the oldest to the newest one of
-- calibration, in one segment, none of the m missing (method, section 4).
-- Reads:  marked_vectors
-- A row:  one calibration vector.
SELECT channel_id, time, cell_key
FROM marked_vectors
WHERE calibration_vector = 1 AND cell_key IS NOT NULL
