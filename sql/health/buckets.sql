-- Buckets: scored vectors counted in full strides; what the stored form keeps. A vector out of range is
-- always novel, so the kept ones hold all that is counted.
-- Reads:  kept
-- A row:  one full bucket of stride vectors of one channel, numbered from 0.
SELECT
  channel_id,
  bucket_no,
  MIN(time) AS first_time,
  MAX(time) AS last_time,
  CAST(SUM(vector.novel) AS BIGINT) AS novel,
  CAST(SUM(vector.out_of_range) AS BIGINT) AS out_of_range
FROM kept AS vector
GROUP BY channel_id, bucket_no
HAVING MAX(closing) = 1
