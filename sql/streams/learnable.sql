-- Learnable, in stored order: the calibration vectors of one channel; see streams/vectors.sql.
-- Reads:  streamed, the vectors of the channel's calibration.
-- A row:  one calibration vector.
-- Slots:  :channel_id
SELECT CAST(:channel_id AS INTEGER) AS channel_id, time, cell_key, out_of_order
FROM streamed
