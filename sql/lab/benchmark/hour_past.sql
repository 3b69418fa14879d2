-- Not part of the method: the portable rules do not hold here; gam benchmark runs it on DuckDB only.
-- Hour, past: the buckets of the last window that stays, in order.
-- Slots:  :lookback  microseconds
--         :buckets   of a window
SELECT version_id, novel
FROM (
  SELECT
    version_id,
    bucket_no,
    novel,
    ROW_NUMBER() OVER (PARTITION BY version_id ORDER BY bucket_no DESC) AS places_back
  FROM (
    SELECT *, MAX(last_time) OVER (PARTITION BY version_id) AS newest_time
    FROM gam_state_bucket
  ) AS dated
  WHERE last_time < newest_time - :lookback
) AS staying
WHERE places_back <= :buckets
ORDER BY version_id, bucket_no
