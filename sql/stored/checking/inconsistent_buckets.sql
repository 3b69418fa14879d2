-- Inconsistent buckets: what must hold within the visible buckets of a version, whatever the source: numbers without
-- a gap from where pruning left them, times in order, counts within their bounds, windows that are the sum of
-- their buckets (Eq. 2).
-- Reads:  checked, stored_visible_bucket, stored_bucket
-- A row:  one version with buckets; since is the beginning of the first that is inconsistent, NULL if all is well.
SELECT
  version_id,
  CAST(COUNT(*) AS BIGINT) AS buckets,
  CAST(SUM(is_torn) AS BIGINT) AS torn,
  CAST(SUM(is_misplaced) AS BIGINT) AS misplaced,
  CAST(SUM(is_miscounted) AS BIGINT) AS miscounted,
  CAST(SUM(is_unsummed) AS BIGINT) AS unsummed,
  MIN(CASE WHEN is_torn + is_misplaced + is_miscounted + is_unsummed > 0 THEN judged.first_time END)
    AS since
FROM (
  SELECT
    course.version_id AS version_id,
    course.first_time AS first_time,
    CASE
      WHEN course.places = 1 AND course.bucket_no <= course.first_bucket THEN 0
      WHEN course.bucket_no = course.previous_no + 1 THEN 0
      ELSE 1
    END AS is_torn,
    CASE
      WHEN course.first_time > course.last_time OR course.context_time > course.last_time THEN 1
      WHEN course.places > 1 AND course.first_time <= course.previous_time THEN 1
      ELSE 0
    END AS is_misplaced,
    CASE
      WHEN course.samples < course.stride OR course.novel > course.stride THEN 1
      WHEN course.out_of_range > course.novel OR course.out_of_range < 0 THEN 1
      WHEN course.still IS NULL THEN CASE WHEN course.still_after IS NULL THEN 0 ELSE 1 END
      WHEN course.still_after IS NULL THEN 1
      WHEN course.still < 0 OR course.still > course.samples - course.stride THEN 1
      ELSE 0
    END AS is_miscounted,
    CASE
      WHEN (course.bucket_no + 1) * course.stride < course.window_length
        THEN CASE WHEN course.novel_in_window IS NULL THEN 0 ELSE 1 END
      WHEN course.novel_in_window IS NULL THEN 1
      WHEN earlier.hit = 1 AND course.novel_in_window <> course.novel_so_far - earlier.novel_so_far THEN 1
      WHEN course.places * course.stride = course.window_length
        AND course.novel_in_window <> course.novel_so_far
        THEN 1
      ELSE 0
    END AS is_unsummed
  FROM (
    SELECT
      bucket.version_id AS version_id,
      bucket.bucket_no AS bucket_no,
      bucket.first_time AS first_time,
      bucket.last_time AS last_time,
      bucket.context_time AS context_time,
      bucket.samples AS samples,
      written.still AS still,
      version.still_after AS still_after,
      bucket.novel AS novel,
      bucket.out_of_range AS out_of_range,
      bucket.novel_in_window AS novel_in_window,
      bucket.bucket_no * version.stride AS begin_number,
      version.first_bucket AS first_bucket,
      version.window_length AS window_length,
      version.stride AS stride,
      CAST(
        ROW_NUMBER() OVER (PARTITION BY bucket.version_id ORDER BY bucket.bucket_no) AS BIGINT
      ) AS places,
      LAG(bucket.bucket_no, 1) OVER (PARTITION BY bucket.version_id ORDER BY bucket.bucket_no)
        AS previous_no,
      LAG(bucket.last_time, 1) OVER (PARTITION BY bucket.version_id ORDER BY bucket.bucket_no)
        AS previous_time,
      CAST(
        SUM(bucket.novel) OVER (
          PARTITION BY bucket.version_id
          ORDER BY bucket.bucket_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS novel_so_far
    FROM stored_visible_bucket AS bucket
    JOIN checked AS version ON version.version_id = bucket.version_id
    JOIN stored_bucket AS written
      ON written.version_id = bucket.version_id
      AND written.bucket_no = bucket.bucket_no
      AND written.run_id = bucket.run_id
  ) AS course
  LEFT JOIN (
    SELECT
      bucket.version_id AS version_id,
      bucket.bucket_no * version.stride + version.window_length AS end_number,
      CAST(
        SUM(bucket.novel) OVER (
          PARTITION BY bucket.version_id
          ORDER BY bucket.bucket_no
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS novel_so_far,
      1 AS hit
    FROM stored_visible_bucket AS bucket
    JOIN checked AS version ON version.version_id = bucket.version_id
  ) AS earlier
    ON earlier.version_id = course.version_id
    AND earlier.end_number = course.begin_number
) AS judged
GROUP BY version_id
