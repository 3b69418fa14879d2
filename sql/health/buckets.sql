-- Buckets: scored vectors counted in full strides; what the stored form keeps. A vector out of range is
-- always novel, so the visited cells hold all that is counted.
-- Reads:  visited
-- A row:  one full bucket of stride vectors of one channel, numbered from 0.
SELECT
  channel_id,
  bucket_no,
  MIN(visit.first_time) AS first_time,
  MAX(visit.last_time) AS last_time,
  CAST(SUM(CASE WHEN visit.novel_cell IS NULL THEN 0 ELSE visit.visits END) AS BIGINT) AS novel,
  CAST(SUM(visit.out_of_range) AS BIGINT) AS out_of_range
FROM visited AS visit
GROUP BY channel_id, bucket_no
HAVING MAX(closing) = 1
