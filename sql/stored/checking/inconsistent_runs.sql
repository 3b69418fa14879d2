-- Inconsistent runs: what must hold between the records of runs and the buckets, whatever the source. A run begins
-- after the bucket that it found settled, reads from that one's context, and says which bucket is settled now. What it
-- has made it writes from the first bucket that has changed on.
-- No number of samples is expected before that where they have gone from the source.
-- It was planned from the finished run before it, or from a later one that pruning took. What a later run
-- wrote anew, or pruning took, says nothing any more.
-- Reads:  checked, stored_finished_run, stored_run, stored_visible_bucket
-- A row:  one version with runs that break one of these rules, or with such that found other samples than were scored
--         (see the view fleet), which is no fault of their record; since is where the first of the latter begins to read.
-- Slots:  :nothing   from_bucket of a run that read nothing: beyond all buckets
--         :long_ago  an instant before all others
SELECT
  version_id,
  CAST(SUM(1 - has_other_samples) AS BIGINT) AS misrecorded,
  CAST(SUM(has_other_samples) AS BIGINT) AS other_samples,
  MIN(CASE WHEN has_other_samples = 1 THEN judged.read_from END) AS since
FROM (
  SELECT
    run.version_id AS version_id,
    run.read_from AS read_from,
    CASE
      WHEN run.read_to IS NOT NULL
        AND run.context_rows <> run.context_expected
        AND (run.runs_back = 1 OR run.read_from < run.read_since)
        THEN 1
      ELSE 0
    END AS has_other_samples,
    CASE
      WHEN run.records <> 1 THEN 1
      WHEN run.planned_from >= run.run_id THEN 1
      WHEN run.previous_id > 0 AND run.planned_from < run.previous_id THEN 1
      WHEN run.read_to IS NULL OR run.settled_bucket IS NULL OR run.from_bucket = :nothing
        THEN CASE
          WHEN run.read_to IS NOT NULL OR run.settled_bucket IS NOT NULL THEN 1
          WHEN run.from_bucket <> :nothing OR run.rows_read <> 0 OR run.context_rows <> 0 THEN 1
          WHEN run.settled_time IS NOT NULL OR run.settled_context IS NOT NULL THEN 1
          WHEN calm.hit = 1 THEN 1
          WHEN run.context_expected <> version.context_rows THEN 1
          WHEN run.run_id < run.reading_id THEN 0
          WHEN run.read_from = version.run_up_from OR resumed.hit = 1 THEN 0
          WHEN ending.hit = 1 AND run.read_from < ending.oldest_context THEN 0
          WHEN CASE WHEN ending.hit = 1 THEN 1 ELSE 0 END = 0 AND version.first_bucket > 0 THEN 0
          ELSE 1
        END
      WHEN run.from_bucket < run.made_from THEN 1
      WHEN run.made_from = 0 AND run.context_expected IS NOT NULL THEN 1
      WHEN run.made_from = 0 AND run.read_from <> version.run_up_from THEN 1
      WHEN run.made_from > 0
        AND run.context_expected IS NULL
        AND run.read_from > :long_ago
        AND run.context_rows >= version.context_rows
        THEN 1
      WHEN calm.hit = 1 AND (version.still_after IS NULL OR calm.standing_from > run.read_to) THEN 1
      WHEN run.context_expected <> version.context_rows THEN 1
      WHEN run.settled_bucket < run.last_staying THEN 1
      WHEN stayed.hit = 1 AND stayed.run_id < run.run_id AND stayed.context_time <> run.read_from THEN 1
      WHEN run.settled_bucket = -1
        AND (run.settled_time IS NOT NULL OR run.settled_context IS NOT NULL)
        THEN 1
      WHEN run.settled_bucket > -1 AND (run.settled_time IS NULL OR run.settled_context IS NULL) THEN 1
      WHEN settled.hit = 1
        AND settled.run_id <= run.run_id
        AND (settled.last_time <> run.settled_time OR settled.context_time <> run.settled_context)
        THEN 1
      WHEN run.rows_read < run.context_rows OR run.context_rows < 0 THEN 1
      WHEN run_buckets.hit = 1
        AND (run_buckets.last_time > run.read_to OR run_buckets.samples > run.rows_read - run.context_rows)
        THEN 1
      WHEN run.run_id < run.reading_id THEN 0
      WHEN run.settled_bucket > run.last_staying
        AND run.settled_bucket >= version.first_bucket
        AND CASE WHEN settled.hit = 1 THEN 1 ELSE 0 END = 0
        THEN 1
      WHEN settled.hit = 1 AND run.settled_bucket > run.last_staying AND settled.behind <= run.lookback THEN 1
      WHEN following.hit = 1 AND following.behind > run.lookback THEN 1
      ELSE 0
    END AS is_inconsistent
  FROM (
    SELECT
      version_id,
      run_id,
      from_bucket,
      made_from,
      made_from - 1 AS last_staying,
      lookback,
      read_from,
      read_to,
      rows_read,
      context_rows,
      context_expected,
      settled_bucket,
      settled_bucket + 1 AS next_bucket,
      settled_time,
      settled_context,
      planned_from,
      LAG(run_id, 1) OVER (PARTITION BY version_id ORDER BY run_id) AS previous_id,
      CAST(COUNT(*) OVER (PARTITION BY version_id, run_id) AS BIGINT) AS records,
      MAX(CASE WHEN settled_bucket IS NOT NULL THEN run_id END) OVER (PARTITION BY version_id)
        AS reading_id,
      CAST(ROW_NUMBER() OVER (PARTITION BY version_id ORDER BY run_id DESC) AS BIGINT) AS runs_back,
      MIN(CASE WHEN read_to IS NOT NULL THEN read_from ELSE 4611686018427387904 END) OVER (
        PARTITION BY version_id ORDER BY run_id DESC ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING
      ) AS read_since
    FROM (
      SELECT
        finished.version_id AS version_id,
        finished.run_id AS run_id,
        finished.from_bucket AS from_bucket,
        CASE WHEN making.made_from IS NULL THEN finished.from_bucket ELSE making.made_from END AS made_from,
        finished.lookback AS lookback,
        finished.read_from AS read_from,
        finished.read_to AS read_to,
        finished.rows_read AS rows_read,
        finished.context_rows AS context_rows,
        finished.context_expected AS context_expected,
        finished.settled_bucket AS settled_bucket,
        finished.settled_time AS settled_time,
        finished.settled_context AS settled_context,
        finished.planned_from AS planned_from
      FROM stored_finished_run AS finished
      JOIN (
        SELECT version_id, run_id, MAX(recorded.made_from) AS made_from
        FROM stored_run AS recorded
        GROUP BY version_id, run_id
      ) AS making ON making.version_id = finished.version_id AND making.run_id = finished.run_id
    ) AS run_record
  ) AS run
  JOIN checked AS version ON version.version_id = run.version_id
  LEFT JOIN (
    SELECT version_id, bucket_no, run_id, context_time, 1 AS hit
    FROM stored_visible_bucket
  ) AS stayed ON stayed.version_id = run.version_id AND stayed.bucket_no = run.last_staying
  LEFT JOIN (
    SELECT
      version_id,
      bucket_no,
      run_id,
      last_time,
      context_time,
      MAX(last_time) OVER (PARTITION BY version_id) - last_time AS behind,
      1 AS hit
    FROM stored_visible_bucket
  ) AS settled ON settled.version_id = run.version_id AND settled.bucket_no = run.settled_bucket
  LEFT JOIN (
    SELECT DISTINCT version_id, context_time, 1 AS hit
    FROM stored_visible_bucket
  ) AS resumed ON resumed.version_id = run.version_id AND resumed.context_time = run.read_from
  LEFT JOIN (
    SELECT version_id, MIN(context_time) AS oldest_context, 1 AS hit
    FROM stored_visible_bucket
    GROUP BY version_id
  ) AS ending ON ending.version_id = run.version_id
  LEFT JOIN (
    SELECT
      version_id,
      bucket_no,
      MAX(last_time) OVER (PARTITION BY version_id) - last_time AS behind,
      1 AS hit
    FROM stored_visible_bucket
  ) AS following ON following.version_id = run.version_id AND following.bucket_no = run.next_bucket
  LEFT JOIN (
    SELECT
      version_id,
      run_id,
      MAX(written.last_time) AS last_time,
      CAST(SUM(written.samples) AS BIGINT) AS samples,
      1 AS hit
    FROM stored_visible_bucket AS written
    GROUP BY version_id, run_id
  ) AS run_buckets ON run_buckets.version_id = run.version_id AND run_buckets.run_id = run.run_id
  LEFT JOIN (
    SELECT version_id, run_id, MAX(read.still_since) AS standing_from, 1 AS hit
    FROM stored_run AS read
    WHERE still_since IS NOT NULL
    GROUP BY version_id, run_id
  ) AS calm ON calm.version_id = run.version_id AND calm.run_id = run.run_id
) AS judged
WHERE is_inconsistent = 1 OR has_other_samples = 1
GROUP BY version_id, has_other_samples
