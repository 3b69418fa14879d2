-- Learnable: the vectors of calibration, where that is one interval and no segment ends; as
-- calibration/learnable_short.sql, with what shows that an instant occurs twice.
-- Reads:  vectors
-- A row:  one calibration vector, or a sample that has the instant of the one before it: doubled = 1.
SELECT channel_id, time, cell_key, doubled
FROM vectors
WHERE cell_key IS NOT NULL OR doubled = 1
