-- Program changed: as changed where states are of programs, and from the first bucket on of which the readings whose program is
-- not judged are not stored just so, those after the last full bucket among them.
-- Reads:  changed_buckets, unknown_programs, former_programs
-- A row:  one channel; differs = 1 if there is such a bucket.
SELECT
  part.channel_id AS channel_id,
  part.version_id AS version_id,
  CASE
    WHEN ran.hit = 1 AND ran.first_bucket < part.first_bucket THEN ran.first_bucket
    ELSE part.first_bucket
  END AS first_bucket,
  CASE WHEN ran.hit = 1 THEN 1 ELSE part.differs END AS differs
FROM changed_buckets AS part
LEFT JOIN (
  SELECT channel_id, MIN(bucket_no) AS first_bucket, 1 AS hit
  FROM (
    SELECT
      channel_id,
      bucket_no,
      CAST(SUM(is_new) AS BIGINT) AS new_rows,
      CAST(SUM(1 - is_new) AS BIGINT) AS former_rows
    FROM (
      SELECT channel_id, bucket_no, program, readings, first_time, last_time, 1 AS is_new
      FROM unknown_programs
      UNION ALL
      SELECT channel_id, bucket_no, program, readings, first_time, last_time, 0 AS is_new
      FROM former_programs
    ) AS counted
    GROUP BY channel_id, bucket_no, program, readings, first_time, last_time
  ) AS matched
  WHERE new_rows <> former_rows
  GROUP BY channel_id
) AS ran ON ran.channel_id = part.channel_id
