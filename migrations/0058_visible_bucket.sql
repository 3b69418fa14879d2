-- Visible bucket, made again: of each bucket the row of the newest finished run that reached it. A run hides all rows of
-- earlier ones from from_bucket on; only runs that may (hides) are put in order, with those before them.
CREATE OR REPLACE VIEW stored_visible_bucket AS
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id,
  written.first_time AS first_time,
  written.last_time AS last_time,
  written.context_time AS context_time,
  written.samples AS samples,
  written.novel AS novel,
  written.out_of_range AS out_of_range,
  written.novel_in_window AS novel_in_window
FROM stored_bucket AS written
JOIN stored_finished_run AS finished
  ON finished.version_id = written.version_id AND finished.run_id = written.run_id
LEFT JOIN (
  SELECT version_id, run_id, hidden_from, 1 AS hit
  FROM (
    SELECT
      run.version_id AS version_id,
      run.run_id AS run_id,
      CAST(ROW_NUMBER() OVER (PARTITION BY run.version_id ORDER BY run.run_id DESC) AS BIGINT) AS runs_back,
      MIN(run.from_bucket) OVER (
        PARTITION BY run.version_id ORDER BY run.run_id DESC ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING
      ) AS hidden_from
    FROM stored_finished_run AS run
    JOIN (
      SELECT version_id, MAX(run_id) AS newest_id
      FROM stored_run
      WHERE hides IS NULL
      GROUP BY version_id
    ) AS hiding ON hiding.version_id = run.version_id
    WHERE run.run_id <= hiding.newest_id
  ) AS placed
  WHERE runs_back > 1
) AS later ON later.version_id = written.version_id AND later.run_id = written.run_id
WHERE written.bucket_no >= finished.from_bucket
  AND CASE WHEN later.hit = 1 AND written.bucket_no >= later.hidden_from THEN 1 ELSE 0 END = 0;

COMMENT ON VIEW stored_visible_bucket
  IS 'Full buckets of scored vectors: of each the row of the newest finished run that reached it';
COMMENT ON COLUMN stored_visible_bucket.version_id IS 'The version';
COMMENT ON COLUMN stored_visible_bucket.bucket_no
  IS 'Number of the bucket: (number of a scored vector - 1) div stride';
COMMENT ON COLUMN stored_visible_bucket.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_visible_bucket.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_visible_bucket.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_visible_bucket.context_time
  IS 'Time of the oldest sample of the next possible vector: where a restart reads from';
COMMENT ON COLUMN stored_visible_bucket.samples
  IS 'Samples after the previous bucket up to the end of this one, missing ones included';
COMMENT ON COLUMN stored_visible_bucket.novel IS 'Vectors in it whose cell is not in the support';
COMMENT ON COLUMN stored_visible_bucket.out_of_range
  IS 'Vectors in it with a sample outside the range of calibration';
COMMENT ON COLUMN stored_visible_bucket.novel_in_window
  IS 'Novel vectors in the window that ends with it; NULL until the window is full';
