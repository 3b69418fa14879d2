-- Last ranges: what runs have read, as far back as rows may come late; the runs since the last that allowed for such
-- rows, or read all there was.
-- Reads:  stored_finished_run
-- A row:  one run of one version; begins = 1 if nothing before it needs to be known.
-- Slots:  :lookback  how late a row may come, in the unit of time
SELECT
  run.version_id AS version_id,
  run.run_id AS run_id,
  run.read_from AS read_from,
  run.read_to AS read_to,
  run.rows_read AS rows_read,
  chain.newest_time AS newest_time,
  CASE WHEN run.run_id = chain.first_id THEN 1 ELSE 0 END AS begins
FROM stored_finished_run AS run
JOIN (
  SELECT
    version_id,
    MAX(earlier.read_to) AS newest_time,
    MAX(
      CASE
        WHEN earlier.lookback >= :lookback OR earlier.context_expected IS NULL THEN earlier.run_id
        ELSE -1
      END
    ) AS first_id
  FROM stored_finished_run AS earlier
  WHERE earlier.settled_bucket IS NOT NULL
  GROUP BY version_id
) AS chain ON chain.version_id = run.version_id
WHERE run.settled_bucket IS NOT NULL
  AND chain.first_id >= 0
  AND run.run_id >= chain.first_id
  AND run.read_to > chain.newest_time - :lookback
