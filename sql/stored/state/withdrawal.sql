-- Withdrawal: the second row of a run that gives way to another one: neither counts any more.
-- Reads:  stored_run
-- A row:  one version of the run.
-- Slots:  :run_id
SELECT
  run_id,
  version_id,
  from_bucket,
  read_from,
  read_to,
  rows_read,
  context_rows,
  context_expected,
  calibration_readings,
  lookback,
  settled_bucket,
  settled_time,
  settled_context,
  started,
  committed,
  planned_from,
  hides,
  CAST(1 AS BIGINT) AS withdrawn
FROM stored_run
WHERE run_id = :run_id
