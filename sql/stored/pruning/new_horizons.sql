-- New horizons: how far back pruning leaves buckets and novel cells, where that is no longer what was recorded.
-- Reads:  horizons, stored_visible_bucket, stored_horizon
-- A row:  one version of which something goes now.
SELECT version_id, first_bucket, first_novel
FROM (
  SELECT
    staying.version_id AS version_id,
    CASE WHEN staying.first_bucket > seen.oldest_bucket THEN staying.first_bucket ELSE current_horizon.first_bucket END
      AS first_bucket,
    CASE
      WHEN staying.first_novel > current_horizon.first_novel THEN staying.first_novel
      ELSE current_horizon.first_novel
    END AS first_novel,
    current_horizon.first_bucket AS current_bucket,
    current_horizon.first_novel AS current_novel
  FROM horizons AS staying
  JOIN (
    SELECT version_id, MIN(bucket_no) AS oldest_bucket
    FROM stored_visible_bucket
    GROUP BY version_id
  ) AS seen ON seen.version_id = staying.version_id
  JOIN (
    SELECT
      version_id,
      MAX(horizon.first_bucket) AS first_bucket,
      MAX(horizon.first_novel) AS first_novel
    FROM (
      SELECT version_id, 0 AS first_bucket, 0 AS first_novel
      FROM horizons
      UNION ALL
      SELECT version_id, first_bucket, first_novel
      FROM stored_horizon
    ) AS horizon
    GROUP BY version_id
  ) AS current_horizon ON current_horizon.version_id = staying.version_id
  WHERE staying.first_bucket > seen.oldest_bucket OR staying.first_novel > seen.oldest_bucket
) AS change
WHERE first_bucket > current_bucket OR first_novel > current_novel
