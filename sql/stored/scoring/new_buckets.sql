-- New buckets: the full buckets of this run, numbered on from those that stay.
-- Reads:  buckets, bucket_ends, cohort, seen
-- A row:  one bucket; samples counts those after the end of the bucket before.
-- Slots:  :differing  the column buckets where channels differ in it; none where all share it
SELECT
  full_bucket.channel_id AS channel_id,
  member.version_id AS version_id,
  :differing,
  full_bucket.bucket_no + member.first_bucket AS bucket_no,
  full_bucket.first_time AS first_time,
  full_bucket.last_time AS last_time,
  full_bucket.context_time AS context_time,
  full_bucket.end_position
  - CASE WHEN full_bucket.bucket_no = 0 THEN ranged.context_rows ELSE full_bucket.previous_end END
    AS samples,
  full_bucket.novel AS novel,
  full_bucket.out_of_range AS out_of_range
FROM (
  SELECT
    counted.channel_id AS channel_id,
    counted.bucket_no AS bucket_no,
    counted.first_time AS first_time,
    counted.last_time AS last_time,
    ending.context_time AS context_time,
    ending.end_position AS end_position,
    counted.novel AS novel,
    counted.out_of_range AS out_of_range,
    LAG(ending.end_position, 1) OVER (PARTITION BY counted.channel_id ORDER BY counted.bucket_no)
      AS previous_end
  FROM buckets AS counted
  JOIN bucket_ends AS ending
    ON ending.channel_id = counted.channel_id AND ending.bucket_no = counted.bucket_no
) AS full_bucket
JOIN cohort AS member ON member.channel_id = full_bucket.channel_id
JOIN seen AS ranged ON ranged.channel_id = full_bucket.channel_id
