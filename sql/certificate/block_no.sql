-- Block no: which block of W vectors a calibration vector is in; the short rest joins the last block. Where that gives
-- fewer than 8 blocks, there are 8 of them, or as many as vectors (method, section 5).
-- Slots:  :place    i, the number of the vector, counted from 0
--         :vectors  n, the calibration vectors of the channel
--         :window   W, in vectors
CASE
  WHEN :vectors < 8 * :window
    THEN FLOOR((CAST(CASE WHEN :vectors < 8 THEN :vectors ELSE 8 END * :place AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:vectors AS DOUBLE))
  WHEN :place >= :vectors - :vectors % :window
    THEN FLOOR((CAST(:vectors AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:window AS DOUBLE)) - 1
  ELSE FLOOR((CAST(:place AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:window AS DOUBLE))
END
