-- New horizons: how far back pruning leaves buckets and novel cells, where that is no longer what was recorded.
-- Reads:  horizons, stored_visible_bucket, stored_horizon
-- A row:  one version of which something goes now.
SELECT version_id, first_bucket, first_novel
FROM (
  SELECT
    staying.version_id AS version_id,
    CASE WHEN staying.first_bucket > seen.oldest_bucket THEN staying.first_bucket ELSE known.first_bucket END
      AS first_bucket,
    CASE WHEN staying.first_novel > known.first_novel THEN staying.first_novel ELSE known.first_novel END
      AS first_novel,
    known.first_bucket AS known_bucket,
    known.first_novel AS known_novel
  FROM horizons AS staying
  JOIN (
    SELECT version_id, MIN(bucket_no) AS oldest_bucket
    FROM stored_visible_bucket
    GROUP BY version_id
  ) AS seen ON seen.version_id = staying.version_id
  JOIN (
    SELECT
      version_id,
      MAX(every_one.first_bucket) AS first_bucket,
      MAX(every_one.first_novel) AS first_novel
    FROM (
      SELECT version_id, 0 AS first_bucket, 0 AS first_novel
      FROM horizons
      UNION ALL
      SELECT version_id, first_bucket, first_novel
      FROM stored_horizon
    ) AS every_one
    GROUP BY version_id
  ) AS known ON known.version_id = staying.version_id
  WHERE staying.first_bucket > seen.oldest_bucket OR staying.first_novel > seen.oldest_bucket
) AS told
WHERE first_bucket > known_bucket OR first_novel > known_novel
