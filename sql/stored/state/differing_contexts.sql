-- Differing contexts: where a run found another number of samples before its first bucket than were there when that
-- bucket was scored. More of them came later than lookback; where there are fewer, rows were taken away. As in the view
-- fleet, a later run that began to read no later speaks in the place of an earlier one.
-- Reads:  status_rows, stored_finished_run
-- A row:  one version and one kind: late or lost. differing is the largest number that one run found; since and until
--         are where the first of these runs began to read, and how far the last one read.
SELECT
  version_id,
  kind,
  CAST(MAX(difference.differing) AS BIGINT) AS differing,
  MIN(difference.read_from) AS since,
  MAX(difference.read_to) AS until
FROM (
  SELECT
    version_id,
    read_from,
    read_to,
    CASE WHEN surplus > 0 THEN 'late' ELSE 'lost' END AS kind,
    CASE WHEN surplus > 0 THEN surplus ELSE -surplus END AS differing
  FROM (
    SELECT
      run.version_id AS version_id,
      run.read_from AS read_from,
      run.read_to AS read_to,
      run.context_rows - run.context_expected AS surplus,
      CAST(ROW_NUMBER() OVER (PARTITION BY run.version_id ORDER BY run.run_id DESC) AS BIGINT) AS runs_back,
      MIN(CASE WHEN run.read_to IS NOT NULL THEN run.read_from ELSE 4611686018427387904 END) OVER (
        PARTITION BY run.version_id ORDER BY run.run_id DESC ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING
      ) AS read_since
    FROM stored_finished_run AS run
    JOIN status_rows AS status ON status.version_id = run.version_id
    WHERE status.differing_contexts > 0
  ) AS finished
  WHERE read_to IS NOT NULL AND surplus <> 0 AND (runs_back = 1 OR read_from < read_since)
) AS difference
GROUP BY version_id, kind
