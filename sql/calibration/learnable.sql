-- Learnable: the vectors that calibration teaches: every sample from the oldest to the newest one of
-- calibration, in one segment, none of the m missing (method, section 4). Where calibration is one interval and
-- no segment ends, the vectors of its samples alone are all of them.
-- Reads:  vectors
-- A row:  one calibration vector; where it is taken on trust that no instant occurs twice, also a sample that has the
--         instant of the one before it: doubled = 1.
-- Slots:  :carried  columns that travel with the vector
--         :taught   whether calibration teaches a vector in which no sample is missing
--         :needed   what else makes a row stay
SELECT
  channel_id,
  time,
  cell_key,
  :carried
FROM vectors
WHERE cell_key IS NOT NULL AND :taught OR :needed
