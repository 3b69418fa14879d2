-- Judged until: from which judgement on the versions of a cohort are to be judged, given what stays of them.
-- Reads:  cohort, stored_limit, stored_visible_judgement
-- A row:  one version that has, or had, a limit; first_judgement is 0 where no judgement stays.
-- Slots:  :near  a condition on bucket that holds for the last judgement that stays
SELECT
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  member.first_bucket AS first_bucket,
  CASE WHEN staying.hit = 1 THEN staying.newest_no + 1 ELSE 0 END AS first_judgement
FROM cohort AS member
JOIN (
  SELECT DISTINCT version_id
  FROM stored_limit
  WHERE height IS NOT NULL
) AS judged ON judged.version_id = member.version_id
LEFT JOIN (
  SELECT bucket.version_id AS version_id, MAX(bucket.judgement_no) AS newest_no, 1 AS hit
  FROM stored_visible_judgement AS bucket
  JOIN cohort AS part ON part.version_id = bucket.version_id
  WHERE bucket.bucket_no < part.first_bucket AND :near
  GROUP BY bucket.version_id
) AS staying ON staying.version_id = member.version_id
