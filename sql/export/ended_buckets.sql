-- Ended buckets: those that late rows ended. A late row without a value takes vectors away, and with them the
-- last bucket; what replaces its row says so by having no times, and is deleted in the same build.
-- Reads:  earlier_bucket, cohort, new_buckets
-- A row:  one bucket that was there and is no more.
SELECT
  member.channel_id AS channel_id,
  ended.bucket_no AS bucket_no,
  CAST(NULL AS BIGINT) AS first_time,
  CAST(NULL AS BIGINT) AS last_time,
  CAST(NULL AS BIGINT) AS context_time,
  CAST(NULL AS BIGINT) AS samples,
  CAST(NULL AS BIGINT) AS novel,
  CAST(NULL AS BIGINT) AS out_of_range,
  CAST(NULL AS BIGINT) AS novel_in_window,
  CAST(NULL AS BIGINT) AS window_length
FROM earlier_bucket AS ended
JOIN cohort AS member ON member.channel_id = ended.channel_id
LEFT JOIN (
  SELECT channel_id, bucket_no, 1 AS hit
  FROM new_buckets
) AS again ON again.channel_id = member.channel_id AND again.bucket_no = ended.bucket_no
WHERE ended.bucket_no >= member.first_bucket AND CASE WHEN again.hit = 1 THEN 0 ELSE 1 END = 1
