-- Inconsistent novel: what must hold between the visible buckets of a version and their novel cells, from where
-- pruning left these: the visits of a bucket's cells are its novel vectors, within its time, in cells that the
-- support has not.
-- Reads:  checked, stored_visible_bucket, stored_visible_novel, stored_support
-- A row:  one version with a bucket of which that does not hold; since is the beginning of the first.
SELECT
  version_id,
  CAST(COUNT(*) AS BIGINT) AS differing,
  MIN(judged.first_time) AS since
FROM (
  SELECT
    bucket.version_id AS version_id,
    bucket.first_time AS first_time,
    CASE
      WHEN bucket.novel <> CASE WHEN held.hit = 1 THEN held.visits ELSE 0 END THEN 1
      WHEN held.hit = 1
        THEN CASE
          WHEN held.earliest < bucket.first_time OR held.latest > bucket.last_time THEN 1
          ELSE held.is_inconsistent
        END
      ELSE 0
    END AS is_inconsistent
  FROM stored_visible_bucket AS bucket
  JOIN checked AS version ON version.version_id = bucket.version_id
  LEFT JOIN (
    SELECT
      cell.version_id AS version_id,
      cell.bucket_no AS bucket_no,
      CAST(SUM(cell.visits) AS BIGINT) AS visits,
      MIN(cell.first_time) AS earliest,
      MAX(cell.last_time) AS latest,
      MAX(
        CASE
          WHEN cell.visits < 1 OR cell.first_time > cell.last_time OR healthy_cell.hit = 1 THEN 1
          ELSE 0
        END
      ) AS is_inconsistent,
      1 AS hit
    FROM stored_visible_novel AS cell
    JOIN checked AS version ON version.version_id = cell.version_id
    LEFT JOIN (
      SELECT support_id, cell_key, 1 AS hit
      FROM stored_support
    ) AS healthy_cell ON healthy_cell.support_id = version.support_id AND healthy_cell.cell_key = cell.cell_key
    GROUP BY cell.version_id, cell.bucket_no
  ) AS held ON held.version_id = bucket.version_id AND held.bucket_no = bucket.bucket_no
  WHERE bucket.bucket_no >= version.first_novel
) AS judged
WHERE is_inconsistent = 1
GROUP BY version_id
