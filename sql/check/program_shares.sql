-- Program shares: each program of each channel: how often it runs, how much calibration holds, how much comes later.
-- Reads:  channels, program_runs, taught_runs, taught_days, later_readings, taught_programs
-- A row:  one program of one channel, in order; is_taught = 1 where its calibration, or that of its pool, holds it.
SELECT
  named.asset AS asset,
  named.channel AS channel,
  ran.program AS program,
  ran.readings AS readings,
  ran.runs AS runs,
  CASE WHEN taught.hit = 1 THEN taught.readings ELSE CAST(0 AS BIGINT) END AS calibration_readings,
  CASE WHEN taught.hit = 1 THEN taught.runs ELSE CAST(0 AS BIGINT) END AS calibration_runs,
  CASE WHEN dated.hit = 1 THEN dated.days ELSE CAST(0 AS BIGINT) END AS calibration_days,
  CASE WHEN later.hit = 1 THEN later.readings ELSE CAST(0 AS BIGINT) END AS later_readings,
  CASE WHEN pooled.hit = 1 THEN 1 ELSE 0 END AS is_taught
FROM (
  SELECT
    channel_id,
    program,
    CAST(SUM(run.readings) AS BIGINT) AS readings,
    CAST(COUNT(*) AS BIGINT) AS runs
  FROM program_runs AS run
  GROUP BY channel_id, program
) AS ran
JOIN channels AS named ON named.channel_id = ran.channel_id
LEFT JOIN (
  SELECT
    channel_id,
    program,
    CAST(SUM(run.readings) AS BIGINT) AS readings,
    CAST(COUNT(*) AS BIGINT) AS runs,
    1 AS hit
  FROM taught_runs AS run
  GROUP BY channel_id, program
) AS taught ON taught.channel_id = ran.channel_id AND taught.program = ran.program
LEFT JOIN (
  SELECT channel_id, program, days, 1 AS hit
  FROM taught_days
) AS dated ON dated.channel_id = ran.channel_id AND dated.program = ran.program
LEFT JOIN (
  SELECT channel_id, program, readings, 1 AS hit
  FROM later_readings
) AS later ON later.channel_id = ran.channel_id AND later.program = ran.program
LEFT JOIN (
  SELECT support_id, program, 1 AS hit
  FROM taught_programs
) AS pooled ON pooled.support_id = named.support_id AND pooled.program = ran.program
ORDER BY ran.channel_id, ran.program
