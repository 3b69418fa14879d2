-- Later readings: what each channel ran after its calibration.
-- Reads:  samples, calibration
-- A row:  one program of one channel.
SELECT sampled.channel_id AS channel_id, sampled.program AS program, CAST(COUNT(*) AS BIGINT) AS readings
FROM samples AS sampled
JOIN (
  SELECT channel_id, MAX(piece.time_to) AS time_to
  FROM calibration AS piece
  GROUP BY channel_id
) AS ending ON ending.channel_id = sampled.channel_id
WHERE sampled.time > ending.time_to AND sampled.program IS NOT NULL
GROUP BY sampled.channel_id, sampled.program
