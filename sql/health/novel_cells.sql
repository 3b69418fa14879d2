-- Novel cells: where the machine went instead, cell by cell; what explains a raised indicator.
-- Reads:  kept, buckets
-- A row:  one cell outside the support in one full bucket.
SELECT
  vector.channel_id AS channel_id,
  vector.bucket_no AS bucket_no,
  vector.cell_key AS cell_key,
  CAST(COUNT(*) AS BIGINT) AS visits,
  MIN(vector.time) AS first_time,
  MAX(vector.time) AS last_time
FROM kept AS vector
JOIN buckets AS full_bucket
  ON full_bucket.channel_id = vector.channel_id AND full_bucket.bucket_no = vector.bucket_no
WHERE vector.novel = 1
GROUP BY vector.channel_id, vector.bucket_no, vector.cell_key
