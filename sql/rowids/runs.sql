-- Runs: where each channel lies among the coded samples, by what was counted before. For SQLite, where a channel is
-- read by the numbers of its rows. Proof: the rows at both ends of each part are looked at; doubled = 1 where one is
-- not where it should be, and all is done again by windows. Between them they lie as pieces has them, one after
-- another in time.
-- Dialect: sqlite
-- Reads:  scale, coded
-- A row:  one channel: its rows, the last one of calibration, and the first one that the scored vectors read.
SELECT
  run.channel_id AS channel_id,
  run.support_id AS support_id,
  run.complete AS complete,
  run.first_row AS first_row,
  run.taught_row AS taught_row,
  run.taught_row - run.context_rows + 1 AS start_row,
  run.last_row AS last_row,
  CASE
    WHEN first_sample.channel_id = run.channel_id
      AND last_sample.channel_id = run.channel_id
      AND (run.taught_row < run.first_row OR taught.time < run.first_scored)
      AND (run.taught_row = run.last_row OR untaught.time >= run.first_scored) THEN 0
    ELSE 1
  END AS doubled
FROM (
  SELECT
    channel_id,
    support_id,
    complete,
    first_scored,
    context_rows,
    rows_before + 1 AS first_row,
    rows_before + samples_before AS taught_row,
    rows_before + readings AS last_row
  FROM (
    SELECT
      channel_id,
      support_id,
      complete,
      first_scored,
      context_rows,
      samples_before,
      readings,
      CAST(
        SUM(readings) OVER (
          ORDER BY channel_id ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) - readings AS rows_before
    FROM scale
  ) AS channel_offset
) AS run
LEFT JOIN coded AS first_sample ON first_sample.rowid = run.first_row
LEFT JOIN coded AS last_sample ON last_sample.rowid = run.last_row
LEFT JOIN coded AS taught ON taught.rowid = run.taught_row
LEFT JOIN coded AS untaught ON untaught.rowid = run.taught_row + 1
