-- Teachable: the calibration vectors of m coordinates as cells, for the certificate. The vector is that
-- of Eq. 1 read from its last sample, so the cells are other numbers for the same sets of vectors.
-- Reads:  embedded
-- A row:  one calibration vector, by the place of its oldest sample.
-- Slots:  :m         coordinates
--         :cell_key  the mixed-radix integer of their bins
SELECT channel_id, place AS time, :cell_key AS cell_key
FROM embedded
WHERE depth >= :m
