-- Buckets: scored vectors counted in full strides; what the stored form keeps.
-- Reads:  numbered
-- A row:  one full bucket of stride vectors of one channel, numbered from 0.
-- Slots:  :stride  vectors per bucket
SELECT
  channel_id,
  bucket_no,
  MIN(time) AS first_time,
  MAX(time) AS last_time,
  SUM(novel) AS novel,
  SUM(out_of_range) AS out_of_range
FROM (
  SELECT
    channel_id,
    time,
    novel,
    out_of_range,
    CAST(FLOOR((CAST(number AS DOUBLE) - CAST(5e-1 AS DOUBLE)) / CAST(:stride AS DOUBLE)) AS BIGINT)
      AS bucket_no
  FROM numbered
) AS placed
GROUP BY channel_id, bucket_no
HAVING COUNT(*) = :stride
