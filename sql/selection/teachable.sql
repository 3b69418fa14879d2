-- Teachable: the calibration vectors of m coordinates as cells, for the certificate. The vector is that
-- of Eq. 1 read from its last sample, so the cells are other numbers for the same sets of vectors.
-- Repeated by Python, once per dimension, and stacked.
-- Reads:  embedded
-- A row:  one calibration vector of one learner, by the place of its oldest sample.
-- Slots:  :m         coordinates
--         :cell_key  the mixed-radix integer of their bins
SELECT
  CAST(vector.channel_id AS BIGINT) * 64 + :m AS channel_id,
  vector.place AS time,
  :cell_key AS cell_key
FROM embedded AS vector
WHERE depth >= :m
