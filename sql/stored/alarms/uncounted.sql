-- Uncounted: the first five judgements of each episode of a monitor of which it is not known yet where the signal was
-- in them, with the bucket before them, from which a run reads them again, and how the version begins.
-- Reads:  stored_visible_episode, stored_visible_judgement, stored_version, stored_band_visit
-- A row:  one judgement, in order.
-- Slots:  :monitor_id
--         :raised_versions  a condition on *judged*: versions that have episodes
SELECT
  wanted.version_id AS version_id,
  wanted.judgement_no AS judgement_no,
  wanted.run_id AS run_id,
  wanted.last_time AS last_time,
  wanted.first_scored AS first_scored,
  wanted.run_up_from AS read_from,
  wanted.bucket_before AS bucket_before
FROM (
  SELECT
    judged.version_id AS version_id,
    judged.judgement_no AS judgement_no,
    judged.run_id AS run_id,
    MIN(judged.last_time) AS last_time,
    MIN(version.first_scored) AS first_scored,
    MIN(version.run_up_from) AS run_up_from,
    MIN(
      judged.bucket_no - CAST(
        FLOOR((CAST(version.window_length AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(version.stride AS DOUBLE)) AS BIGINT
      )
    ) AS bucket_before
  FROM stored_visible_episode AS raised
  JOIN stored_version AS version ON version.version_id = raised.version_id
  JOIN stored_visible_judgement AS judged
    ON judged.version_id = raised.version_id
    AND judged.judgement_no >= raised.first_judgement
    AND judged.judgement_no <= raised.last_judgement
    AND judged.judgement_no < raised.first_judgement + 5
  WHERE raised.monitor_id = :monitor_id AND raised.status IN ('open', 'ended') AND :raised_versions
  GROUP BY judged.version_id, judged.judgement_no, judged.run_id
) AS wanted
LEFT JOIN (
  SELECT DISTINCT version_id, judgement_no, run_id, 1 AS hit
  FROM stored_band_visit
) AS band_visit
  ON band_visit.version_id = wanted.version_id
  AND band_visit.judgement_no = wanted.judgement_no
  AND band_visit.run_id = wanted.run_id
WHERE CASE WHEN band_visit.hit = 1 THEN 0 ELSE 1 END = 1
ORDER BY wanted.version_id, wanted.judgement_no
