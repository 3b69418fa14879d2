-- Last ranges: what runs have summed up of what they read, as far back as rows may come late.
-- Reads:  stored_finished_run, stored_run
-- A row:  one run of one version; begins = 1 if it read all there was, so that nothing before it needs to be known;
--         is_newest = 1 if no later run read anything.
-- Slots:  :lookback  how late a row may come, in the unit of time
--         :since     the first run that is looked at
SELECT
  run.version_id AS version_id,
  run.run_id AS run_id,
  summed.summed_from AS summed_from,
  run.read_to AS read_to,
  summed.read_sum AS read_sum,
  ending.newest_time AS newest_time,
  CASE WHEN run.context_expected IS NULL AND summed.summed_from = run.read_from THEN 1 ELSE 0 END AS begins,
  CASE WHEN run.run_id = ending.newest_run THEN 1 ELSE 0 END AS is_newest
FROM stored_finished_run AS run
JOIN (
  SELECT version_id, MAX(earlier.read_to) AS newest_time, MAX(earlier.run_id) AS newest_run
  FROM stored_finished_run AS earlier
  WHERE earlier.settled_bucket IS NOT NULL AND earlier.run_id >= :since
  GROUP BY version_id
) AS ending ON ending.version_id = run.version_id
JOIN stored_run AS summed ON summed.version_id = run.version_id AND summed.run_id = run.run_id
WHERE run.run_id >= :since
  AND run.settled_bucket IS NOT NULL
  AND summed.read_sum IS NOT NULL
  AND run.read_to > ending.newest_time - :lookback
