-- Usual run: whether runs look like those of programs: how many programs there are, the lower median of the readings of
-- a run, and how often at most a machine runs one program.
-- Reads:  program_runs
-- A row:  one.
SELECT
  CAST(COUNT(DISTINCT ranked.program) AS BIGINT) AS programs,
  MIN(CASE WHEN 2 * ranked.place >= ranked.runs_in_all THEN ranked.readings END) AS usual_run,
  MAX(ranked.turn) AS turns
FROM (
  SELECT
    program,
    readings,
    CAST(ROW_NUMBER() OVER (ORDER BY readings, channel_id, run_no) AS BIGINT) AS place,
    CAST(COUNT(*) OVER () AS BIGINT) AS runs_in_all,
    CAST(ROW_NUMBER() OVER (PARTITION BY channel_id, program ORDER BY run_no) AS BIGINT) AS turn
  FROM program_runs
) AS ranked
