-- Horizons: the first bucket of each version that stays, and the first whose novel cells stay. The active
-- version keeps the buckets that a restart needs, whatever their age: those that lookback reaches and as
-- many before them as a window has. It needs no novel cells, and these never outlast their buckets.
-- Reads:  bucket_ages, stored_visible_novel
-- A row:  one version that has buckets and stays.
-- Slots:  :keep        age of buckets that stay
--         :keep_novel  age of novel cells that stay
--         :novel_rows  rows of novel cells of a version that stay, the newest
SELECT
  version_id,
  first_bucket,
  CASE
    WHEN horizon.first_novel > horizon.first_bucket THEN horizon.first_novel
    ELSE horizon.first_bucket
  END AS first_novel
FROM (
  SELECT
    version_id,
    MIN(CASE WHEN is_needed = 1 OR age <= :keep THEN bucket_no ELSE newest_no + 1 END)
      AS first_bucket,
    MIN(
      CASE
        WHEN age <= :keep_novel AND novel_rows <= :novel_rows THEN bucket_no
        ELSE newest_no + 1
      END
    ) AS first_novel
  FROM (
    SELECT
      aged.version_id AS version_id,
      aged.bucket_no AS bucket_no,
      aged.age AS age,
      reached.newest_no AS newest_no,
      CASE
        WHEN aged.versions_back = 0
          AND (reached.first_new - aged.bucket_no) * aged.stride <= aged.window_length
          THEN 1
        ELSE 0
      END AS is_needed,
      CAST(
        SUM(CASE WHEN unseen.hit = 1 THEN unseen.cells ELSE 0 END) OVER (
          PARTITION BY aged.version_id
          ORDER BY aged.bucket_no DESC
          ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW
        ) AS BIGINT
      ) AS novel_rows
    FROM bucket_ages AS aged
    JOIN (
      SELECT
        version_id,
        MAX(bucket_no) AS newest_no,
        MIN(CASE WHEN is_new = 1 THEN bucket_no END) AS first_new
      FROM bucket_ages
      GROUP BY version_id
    ) AS reached ON reached.version_id = aged.version_id
    LEFT JOIN (
      SELECT version_id, bucket_no, CAST(COUNT(*) AS BIGINT) AS cells, 1 AS hit
      FROM stored_visible_novel
      GROUP BY version_id, bucket_no
    ) AS unseen ON unseen.version_id = aged.version_id AND unseen.bucket_no = aged.bucket_no
  ) AS counted
  GROUP BY version_id
) AS horizon
