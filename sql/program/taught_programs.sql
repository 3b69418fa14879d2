-- Taught programs: what a machine ran in calibration, numbered for each support (both sides, section 5).
-- Reads:  samples, calibration, channels
-- A row:  one program of one support.
-- Slots:  :ordered  the program by which they are numbered: whole numbers by size, texts by their bytes
SELECT
  support_id,
  program,
  CAST(ROW_NUMBER() OVER (PARTITION BY support_id ORDER BY :ordered) AS BIGINT) - 1 AS program_no
FROM (
  SELECT named.support_id AS support_id, sampled.program AS program
  FROM samples AS sampled
  JOIN calibration AS piece ON piece.channel_id = sampled.channel_id
  JOIN channels AS named ON named.channel_id = sampled.channel_id
  WHERE sampled.time BETWEEN piece.time_from AND piece.time_to AND sampled.program IS NOT NULL
  GROUP BY named.support_id, sampled.program
) AS held
