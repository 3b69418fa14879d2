-- Uncounted: the first five judgements of each episode of a monitor of which it is not known yet where the signal was
-- in them, with what a run must know to read them again: the bucket before them, or how the version begins.
-- Reads:  stored_visible_episode, stored_visible_judgement, stored_visible_bucket, stored_version, stored_band_visit
-- A row:  one judgement, in order; of one whose bucket before was pruned there is none.
-- Slots:  :monitor_id
--         :judged_versions, :earlier_versions  conditions on *judged* and *full_bucket*: versions that have episodes
SELECT
  wanted.version_id AS version_id,
  wanted.judgement_no AS judgement_no,
  wanted.run_id AS run_id,
  wanted.last_time AS last_time,
  CASE WHEN earlier.hit = 1 THEN earlier.last_time + 1 ELSE wanted.first_scored END AS first_scored,
  CASE WHEN earlier.hit = 1 THEN earlier.context_time ELSE wanted.run_up_from END AS read_from
FROM (
  SELECT
    judged.version_id AS version_id,
    judged.judgement_no AS judgement_no,
    judged.run_id AS run_id,
    MIN(judged.last_time) AS last_time,
    MIN(made.first_scored) AS first_scored,
    MIN(made.run_up_from) AS run_up_from,
    MIN(
      judged.bucket_no - CAST(
        FLOOR((CAST(made.window_length AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(made.stride AS DOUBLE)) AS BIGINT
      )
    ) AS bucket_before
  FROM stored_visible_episode AS raised
  JOIN stored_version AS made ON made.version_id = raised.version_id
  JOIN stored_visible_judgement AS judged
    ON judged.version_id = raised.version_id
    AND judged.judgement_no >= raised.first_judgement
    AND judged.judgement_no <= raised.last_judgement
    AND judged.judgement_no < raised.first_judgement + 5
  WHERE raised.monitor_id = :monitor_id AND raised.status IN ('open', 'ended') AND :judged_versions
  GROUP BY judged.version_id, judged.judgement_no, judged.run_id
) AS wanted
LEFT JOIN (
  SELECT version_id, bucket_no, last_time, context_time, 1 AS hit
  FROM stored_visible_bucket AS full_bucket
  WHERE :earlier_versions
) AS earlier ON earlier.version_id = wanted.version_id AND earlier.bucket_no = wanted.bucket_before
LEFT JOIN (
  SELECT DISTINCT version_id, judgement_no, run_id, 1 AS hit
  FROM stored_band_visit
) AS known
  ON known.version_id = wanted.version_id
  AND known.judgement_no = wanted.judgement_no
  AND known.run_id = wanted.run_id
WHERE CASE WHEN known.hit = 1 THEN 0 ELSE 1 END = 1 AND (earlier.hit = 1 OR wanted.judgement_no = 0)
ORDER BY wanted.version_id, wanted.judgement_no
