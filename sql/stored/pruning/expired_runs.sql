-- Expired runs: records of runs that go, since no row of theirs stays and nothing that they found is still
-- to be told. Of each version the newest run stays, the newest of those that read furthest, the newest that
-- recorded what is settled, and the newest that counted calibration; so does one that found other samples than
-- were scored, where they are not too old to be scored again. A run whose record goes hides nothing any more,
-- so hidden rows go with it.
-- Reads:  pruned_versions, horizons, staying_buckets, staying_judgements, stored_run
-- A row:  one run of one version, by its key.
SELECT
  run.version_id AS version_id,
  run.run_id AS run_id
FROM stored_run AS run
JOIN pruned_versions AS pruned ON pruned.version_id = run.version_id
JOIN (
  SELECT
    version_id,
    MAX(run_id) AS newest_id,
    MAX(CASE WHEN read_to = furthest THEN run_id END) AS reading_id,
    MAX(CASE WHEN settled_bucket IS NOT NULL THEN run_id END) AS settling_id,
    MAX(CASE WHEN calibration_readings IS NOT NULL THEN run_id END) AS counting_id
  FROM (
    SELECT
      version_id,
      run_id,
      read_to,
      settled_bucket,
      calibration_readings,
      MAX(read_to) OVER (PARTITION BY version_id) AS furthest
    FROM stored_run
  ) AS looked
  GROUP BY version_id
) AS last_run ON last_run.version_id = run.version_id
LEFT JOIN (
  SELECT version_id, first_bucket, 1 AS hit
  FROM horizons
) AS horizon ON horizon.version_id = run.version_id
LEFT JOIN (
  SELECT DISTINCT version_id, run_id, 1 AS hit
  FROM (
    SELECT version_id, run_id
    FROM staying_buckets
    UNION ALL
    SELECT version_id, run_id
    FROM staying_judgements
  ) AS written
) AS staying ON staying.version_id = run.version_id AND staying.run_id = run.run_id
WHERE CASE
  WHEN pruned.goes = 1 THEN 1
  WHEN run.run_id = last_run.newest_id THEN 0
  WHEN run.run_id = last_run.reading_id THEN 0
  WHEN run.run_id = last_run.settling_id THEN 0
  WHEN run.run_id = last_run.counting_id THEN 0
  WHEN staying.hit = 1 THEN 0
  WHEN run.read_to IS NOT NULL
    AND run.context_rows <> run.context_expected
    AND horizon.hit = 1
    AND run.from_bucket > horizon.first_bucket
    THEN 0
  ELSE 1
END = 1
