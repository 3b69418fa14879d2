-- Former novel: what is stored of the novel cells of buckets that a run, or the check of the state, makes anew.
-- Reads:  stored_visible_novel, cohort
-- A row:  one cell outside the support in one bucket.
-- Slots:  :near  a condition on bucket that holds for all of them
SELECT
  member.channel_id AS channel_id,
  member.version_id AS version_id,
  bucket.bucket_no AS bucket_no,
  bucket.cell_key AS cell_key,
  bucket.visits AS visits,
  bucket.first_time AS first_time,
  bucket.last_time AS last_time
FROM stored_visible_novel AS bucket
JOIN cohort AS member ON member.version_id = bucket.version_id
WHERE bucket.bucket_no >= member.first_bucket
  AND :near
