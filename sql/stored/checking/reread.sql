-- Reread: what the last run that read anything would read now, as far as it read. If that is as many rows, no
-- row came since, and its last buckets can be compared as well.
-- Reads:  identified, cohort, stored_finished_run
-- A row:  one channel that was read and has a row; ends_now = 1 if one of them is at the end of what was read.
SELECT
  ranged.channel_id AS channel_id,
  ranged.rows_then AS rows_then,
  CAST(SUM(CASE WHEN reading.time BETWEEN ranged.read_from AND ranged.read_to THEN 1 ELSE 0 END) AS BIGINT)
    AS rows_now,
  MAX(CASE WHEN reading.time = ranged.read_to THEN 1 ELSE 0 END) AS ends_now
FROM (
  SELECT
    member.channel_id AS channel_id,
    run.rows_read AS rows_then,
    run.read_from AS read_from,
    run.read_to AS read_to
  FROM stored_finished_run AS run
  JOIN (
    SELECT version_id, MAX(run_id) AS newest_id
    FROM stored_finished_run
    WHERE settled_bucket IS NOT NULL
    GROUP BY version_id
  ) AS reading ON reading.version_id = run.version_id AND reading.newest_id = run.run_id
  JOIN cohort AS member ON member.version_id = run.version_id
) AS ranged
JOIN identified AS reading ON reading.channel_id = ranged.channel_id
GROUP BY ranged.channel_id, ranged.rows_then
