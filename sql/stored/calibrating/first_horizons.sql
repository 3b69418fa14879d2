-- First horizons: of a state that is older than the record of what was pruned, from where on buckets and novel
-- cells are whole.
-- Reads:  stored_visible_bucket, stored_visible_novel, stored_horizon
-- A row:  one version without a record, of which something is gone.
SELECT version_id, first_bucket, first_novel
FROM (
  SELECT
    full_bucket.version_id AS version_id,
    MIN(full_bucket.bucket_no) AS first_bucket,
    MAX(
      CASE
        WHEN full_bucket.novel = CASE WHEN held.hit = 1 THEN held.visits ELSE 0 END THEN 0
        ELSE full_bucket.bucket_no + 1
      END
    ) AS first_novel
  FROM stored_visible_bucket AS full_bucket
  LEFT JOIN (
    SELECT
      version_id,
      bucket_no,
      CAST(SUM(cell.visits) AS BIGINT) AS visits,
      1 AS hit
    FROM stored_visible_novel AS cell
    GROUP BY version_id, bucket_no
  ) AS held
    ON held.version_id = full_bucket.version_id AND held.bucket_no = full_bucket.bucket_no
  LEFT JOIN (
    SELECT version_id, 1 AS hit
    FROM stored_horizon
    GROUP BY version_id
  ) AS recorded ON recorded.version_id = full_bucket.version_id
  WHERE CASE WHEN recorded.hit = 1 THEN 0 ELSE 1 END = 1
  GROUP BY full_bucket.version_id
) AS seen
WHERE first_bucket > 0 OR first_novel > 0
