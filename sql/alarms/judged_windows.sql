-- Judged windows: the full windows of scored vectors, one after another (alarms, section 2).
-- Reads:  bucket_counts
-- A row:  one judgement, numbered from 0.
-- Slots:  :buckets  W / stride, the buckets of a window
SELECT
  channel_id,
  judgement_no,
  MAX(counted.bucket_no) AS last_bucket,
  MIN(counted.first_time) AS first_time,
  MAX(counted.last_time) AS last_time,
  CAST(SUM(counted.novel) AS BIGINT) AS novel
FROM (
  SELECT
    channel_id,
    CAST(
      FLOOR((CAST(bucket_no AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:buckets AS DOUBLE)) AS BIGINT
    ) AS judgement_no,
    bucket_no,
    first_time,
    last_time,
    novel
  FROM bucket_counts
) AS counted
GROUP BY channel_id, judgement_no
HAVING CAST(COUNT(*) AS BIGINT) = :buckets
