-- Judged ranges: the first and the last of the judgements that are looked at again.
-- Reads:  followed, stored_version, stored_limit, stored_visible_judgement
-- A row:  one version that has, or had, a limit (is_judged = 0: had); NULL where nothing is judged yet.
-- Slots:  :near  a condition on bucket that holds for all of them
SELECT
  part.channel_id AS channel_id,
  part.version_id AS version_id,
  version.first_scored AS first_scored,
  CASE WHEN latest.height IS NOT NULL THEN 1 ELSE 0 END AS is_judged,
  CASE WHEN judged.hit = 1 THEN judged.first_judgement END AS first_judgement,
  CASE WHEN judged.hit = 1 THEN judged.last_judgement END AS last_judgement,
  CASE WHEN judged.hit = 1 THEN judged.last_time END AS last_time
FROM followed AS part
JOIN stored_version AS version ON version.version_id = part.version_id
JOIN (
  SELECT
    version_id,
    MAX(limit_row.limit_no) AS newest_no,
    MAX(CASE WHEN limit_row.height IS NOT NULL THEN 1 ELSE 0 END) AS was_judged
  FROM stored_limit AS limit_row
  GROUP BY version_id
) AS limited ON limited.version_id = part.version_id AND limited.was_judged = 1
JOIN stored_limit AS latest
  ON latest.version_id = limited.version_id AND latest.limit_no = limited.newest_no
LEFT JOIN (
  SELECT
    bucket.version_id AS version_id,
    MIN(bucket.judgement_no) AS first_judgement,
    MAX(bucket.judgement_no) AS last_judgement,
    MAX(bucket.last_time) AS last_time,
    1 AS hit
  FROM stored_visible_judgement AS bucket
  JOIN followed AS since ON since.version_id = bucket.version_id
  WHERE bucket.judgement_no >= since.since_judgement AND :near
  GROUP BY bucket.version_id
) AS judged ON judged.version_id = part.version_id
