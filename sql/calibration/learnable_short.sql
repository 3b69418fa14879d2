-- Learnable, short form: where calibration is one interval and no segment ends, the vectors of its
-- samples alone are the calibration vectors.
-- Reads:  vectors
-- A row:  one calibration vector.
SELECT channel_id, time, cell_key
FROM vectors
WHERE cell_key IS NOT NULL
