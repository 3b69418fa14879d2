-- Ran programs: what each machine ran since its calibration, missing readings left out.
-- Reads:  samples, bounds
-- A row:  one program of one channel, NULL where none was told.
SELECT
  sampled.channel_id AS channel_id,
  sampled.program AS program,
  CAST(COUNT(*) AS BIGINT) AS readings,
  MIN(sampled.time) AS first_time,
  MAX(sampled.time) AS last_time
FROM samples AS sampled
JOIN bounds AS scale ON scale.channel_id = sampled.channel_id
WHERE sampled.time >= scale.first_scored AND sampled.value IS NOT NULL
GROUP BY sampled.channel_id, sampled.program
