-- Learnable, in stored order: the calibration vectors of one channel. For DuckDB, by streams/vectors.sql. Proof: no
-- row has doubled = 1, and calibration has as many samples as streams/series.sql was asked for.
-- Reads:  streamed, the samples of the channel's calibration.
-- A row:  one calibration vector, or a sample that is not later than the one before: doubled = 1.
-- Slots:  :channel_id
--         :counted  whether a sample ends a vector that counts
SELECT CAST(:channel_id AS INTEGER) AS channel_id, time, cell_key, out_of_order AS doubled
FROM streamed
WHERE :counted OR out_of_order = 1
