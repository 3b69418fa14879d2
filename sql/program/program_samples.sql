-- Program samples: the samples with the number of the program that the machine ran.
-- Reads:  samples, channels, numbered_programs
-- A row:  one sample; program_no is NULL where no program was told, or one that has no number.
SELECT
  sampled.channel_id AS channel_id,
  sampled.time AS time,
  sampled.value AS value,
  sampled.program AS program,
  CASE WHEN ran.hit = 1 THEN ran.program_no END AS program_no
FROM samples AS sampled
JOIN channels AS named ON named.channel_id = sampled.channel_id
LEFT JOIN (
  SELECT support_id, program, program_no, 1 AS hit
  FROM numbered_programs
) AS ran ON ran.support_id = named.support_id AND ran.program = sampled.program
