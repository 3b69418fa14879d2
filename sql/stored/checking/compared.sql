-- Compared: the buckets that can be, as they are stored and as the source gives them now. A row that came too
-- late, was corrected or went changes the bucket that holds it, or moves all that follow.
-- Reads:  new_buckets, bucket_counts, still_counts, former_buckets, cohort
-- A row:  one channel and day (of the last vector of a bucket) on which they differ; since is the beginning of
--         the first bucket that does.
-- Slots:  :day  a day, in the unit of time
SELECT
  channel_id,
  day_no,
  samples_then,
  samples_now,
  CASE WHEN only_stored > only_found THEN only_stored ELSE only_found END AS differing,
  since
FROM (
  SELECT
    channel_id,
    day_no,
    CAST(SUM(CASE WHEN stored_rows > 0 THEN samples ELSE 0 END) AS BIGINT) AS samples_then,
    CAST(SUM(CASE WHEN source_rows > 0 THEN samples ELSE 0 END) AS BIGINT) AS samples_now,
    CAST(SUM(CASE WHEN source_rows = 0 THEN 1 ELSE 0 END) AS BIGINT) AS only_stored,
    CAST(SUM(CASE WHEN stored_rows = 0 THEN 1 ELSE 0 END) AS BIGINT) AS only_found,
    MIN(CASE WHEN stored_rows <> source_rows THEN first_time END) AS since
  FROM (
    SELECT
      channel_id,
      CAST(
        FLOOR((CAST(last_time AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:day AS DOUBLE)) AS BIGINT
      ) AS day_no,
      bucket_no,
      first_time,
      last_time,
      context_time,
      samples,
      still,
      novel,
      out_of_range,
      novel_in_window,
      CAST(SUM(is_stored) AS BIGINT) AS stored_rows,
      CAST(SUM(1 - is_stored) AS BIGINT) AS source_rows
    FROM (
      SELECT
        former.channel_id AS channel_id,
        former.bucket_no AS bucket_no,
        former.first_time AS first_time,
        former.last_time AS last_time,
        former.context_time AS context_time,
        former.samples AS samples,
        former.still AS still,
        former.novel AS novel,
        former.out_of_range AS out_of_range,
        former.novel_in_window AS novel_in_window,
        1 AS is_stored
      FROM former_buckets AS former
      JOIN cohort AS member ON member.channel_id = former.channel_id
      WHERE former.bucket_no BETWEEN member.oldest_bucket AND member.settled - 1
      UNION ALL
      SELECT
        made.channel_id AS channel_id,
        made.bucket_no AS bucket_no,
        made.first_time AS first_time,
        made.last_time AS last_time,
        made.context_time AS context_time,
        made.samples AS samples,
        CASE WHEN calm.hit = 1 THEN calm.still END AS still,
        made.novel AS novel,
        made.out_of_range AS out_of_range,
        counted.novel_in_window AS novel_in_window,
        0 AS is_stored
      FROM new_buckets AS made
      JOIN bucket_counts AS counted
        ON counted.channel_id = made.channel_id AND counted.bucket_no = made.bucket_no
      JOIN cohort AS member ON member.channel_id = made.channel_id
      LEFT JOIN (
        SELECT channel_id, bucket_no, still, 1 AS hit
        FROM still_counts
      ) AS calm ON calm.channel_id = made.channel_id AND calm.bucket_no = made.bucket_no
      WHERE made.bucket_no BETWEEN member.oldest_bucket AND member.settled - 1
        AND made.last_time <= member.read_until
    ) AS both_sides
    GROUP BY
      channel_id,
      bucket_no,
      first_time,
      last_time,
      context_time,
      samples,
      still,
      novel,
      out_of_range,
      novel_in_window
  ) AS matched
  GROUP BY channel_id, day_no
) AS summed
WHERE only_stored > 0 OR only_found > 0
