-- Visible judgement, made again: of each judgement the row of the newest finished run that reached it, by the same rule
-- as visible_bucket.
CREATE OR REPLACE VIEW stored_visible_judgement AS
SELECT
  written.version_id AS version_id,
  written.bucket_no AS bucket_no,
  written.run_id AS run_id,
  written.judgement_no AS judgement_no,
  written.first_time AS first_time,
  written.last_time AS last_time,
  written.novel AS novel,
  written.root AS root,
  written.reference AS reference,
  written.height AS height,
  written.evidence AS evidence,
  written.is_open AS is_open,
  written.last_zero AS last_zero
FROM stored_judgement AS written
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

COMMENT ON VIEW stored_visible_judgement
  IS 'Judgements of channels that have a limit: of each the row of the newest finished run that reached it';
COMMENT ON COLUMN stored_visible_judgement.version_id IS 'The version';
COMMENT ON COLUMN stored_visible_judgement.bucket_no IS 'The bucket that closes it: its last one';
COMMENT ON COLUMN stored_visible_judgement.run_id IS 'The run that wrote that bucket';
COMMENT ON COLUMN stored_visible_judgement.judgement_no IS 'Number of the judgement, from 0';
COMMENT ON COLUMN stored_visible_judgement.first_time IS 'Time of its first vector';
COMMENT ON COLUMN stored_visible_judgement.last_time IS 'Time of its last vector';
COMMENT ON COLUMN stored_visible_judgement.novel IS 'Novel vectors in its window';
COMMENT ON COLUMN stored_visible_judgement.root IS 'Square root of that, in thousandths';
COMMENT ON COLUMN stored_visible_judgement.reference IS 'Root above which it is raised';
COMMENT ON COLUMN stored_visible_judgement.height IS 'Evidence that opens an episode';
COMMENT ON COLUMN stored_visible_judgement.evidence IS 'How far roots stood above the reference of late, summed';
COMMENT ON COLUMN stored_visible_judgement.is_open IS '1 if it belongs to an episode, else 0';
COMMENT ON COLUMN stored_visible_judgement.last_zero
  IS 'The latest judgement without evidence, up to this one; NULL if there was none';
