-- Novel cells: where the machine went instead, cell by cell; what explains a raised indicator. Of a channel
-- only the last bucket can lack vectors: up to the last full one all are full.
-- Reads:  visited, buckets
-- A row:  one cell outside the support in one full bucket.
SELECT
  visit.channel_id AS channel_id,
  visit.bucket_no AS bucket_no,
  visit.novel_cell AS cell_key,
  CAST(visit.visits AS BIGINT) AS visits,
  visit.first_time AS first_time,
  visit.last_time AS last_time
FROM visited AS visit
JOIN (
  SELECT channel_id, MAX(bucket_no) AS last_bucket
  FROM buckets
  GROUP BY channel_id
) AS full_until ON full_until.channel_id = visit.channel_id
WHERE visit.novel_cell IS NOT NULL AND visit.bucket_no <= full_until.last_bucket
