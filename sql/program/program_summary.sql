-- Program summary: each program of each channel, in calibration and since (both sides, section 5).
-- Reads:  channels, programs, ran_programs
-- A row:  one program of one channel, in order; program is NULL for readings whose program was not told. What speaks of
--         calibration is the pool's.
-- Slots:  :first_time, :last_time  the instants of its first and last reading since calibration, as the source tells time
--         :ordered  the program by which those are ordered that calibration did not hold
SELECT
  named.asset AS asset,
  named.channel AS channel,
  counted.program AS program,
  counted.verdict AS verdict,
  counted.vectors AS vectors,
  counted.unvouched AS unvouched,
  CASE
    WHEN counted.vectors > 0 THEN CAST(counted.unvouched AS DOUBLE) / CAST(counted.vectors AS DOUBLE)
  END AS floor,
  counted.readings AS readings,
  :first_time AS first_time,
  :last_time AS last_time
FROM (
  SELECT
    named.channel_id AS channel_id,
    learnt.program AS program,
    learnt.program_no AS program_no,
    learnt.verdict AS verdict,
    learnt.vectors AS vectors,
    learnt.unvouched AS unvouched,
    CASE WHEN ran.hit = 1 THEN ran.readings ELSE CAST(0 AS BIGINT) END AS readings,
    CASE WHEN ran.hit = 1 THEN ran.first_time END AS first_time,
    CASE WHEN ran.hit = 1 THEN ran.last_time END AS last_time
  FROM channels AS named
  JOIN programs AS learnt ON learnt.support_id = named.support_id
  LEFT JOIN (
    SELECT channel_id, program, readings, first_time, last_time, 1 AS hit
    FROM ran_programs
  ) AS ran ON ran.channel_id = named.channel_id AND ran.program = learnt.program
  UNION ALL
  SELECT
    named.channel_id AS channel_id,
    ran.program AS program,
    CAST(NULL AS BIGINT) AS program_no,
    'unknown' AS verdict,
    CAST(0 AS BIGINT) AS vectors,
    CAST(0 AS BIGINT) AS unvouched,
    ran.readings AS readings,
    ran.first_time AS first_time,
    ran.last_time AS last_time
  FROM ran_programs AS ran
  JOIN channels AS named ON named.channel_id = ran.channel_id
  LEFT JOIN (
    SELECT support_id, program, 1 AS hit
    FROM programs
  ) AS learnt ON learnt.support_id = named.support_id AND learnt.program = ran.program
  WHERE CASE WHEN learnt.hit = 1 THEN 1 ELSE 0 END < 1
) AS counted
JOIN channels AS named ON named.channel_id = counted.channel_id
ORDER BY
  counted.channel_id,
  CASE WHEN counted.program_no IS NULL THEN 1 ELSE 0 END,
  counted.program_no,
  CASE WHEN counted.program IS NULL THEN 1 ELSE 0 END,
  :ordered
