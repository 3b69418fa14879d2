-- Taught readings: the samples of calibration, with what the machine ran.
-- Reads:  samples, calibration
-- A row:  one sample.
SELECT sampled.channel_id AS channel_id, sampled.time AS time, sampled.program AS program
FROM samples AS sampled
JOIN calibration AS piece ON piece.channel_id = sampled.channel_id
WHERE sampled.time BETWEEN piece.time_from AND piece.time_to
