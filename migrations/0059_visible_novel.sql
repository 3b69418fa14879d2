-- Visible novel, made again: the novel cells of the rows that visible_bucket shows, by the same rule.
CREATE OR REPLACE VIEW stored_visible_novel AS
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id,
  written.cell_key AS cell_key,
  written.visits AS visits,
  written.first_time AS first_time,
  written.last_time AS last_time
FROM stored_novel AS written
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

COMMENT ON VIEW stored_visible_novel
  IS 'Novel cells of buckets: of each bucket those of the newest finished run that reached it';
COMMENT ON COLUMN stored_visible_novel.version_id IS 'The version';
COMMENT ON COLUMN stored_visible_novel.bucket_no IS 'The bucket';
COMMENT ON COLUMN stored_visible_novel.run_id IS 'The run that wrote it';
COMMENT ON COLUMN stored_visible_novel.cell_key
  IS 'The cell: its bins on the m axes, as one integer';
COMMENT ON COLUMN stored_visible_novel.visits IS 'Vectors of the bucket in it';
COMMENT ON COLUMN stored_visible_novel.first_time IS 'Time of its first visit in the bucket';
COMMENT ON COLUMN stored_visible_novel.last_time IS 'Time of its last visit in the bucket';
