-- Expired horizons: records of what was pruned that go: a newer one takes their place, or the version goes.
-- Reads:  stored_horizon, new_horizons, pruned_versions
-- A row:  one record, as it is.
SELECT
  recorded.version_id AS version_id,
  recorded.first_bucket AS first_bucket,
  recorded.first_novel AS first_novel
FROM stored_horizon AS recorded
JOIN (
  SELECT version_id
  FROM new_horizons
  UNION ALL
  SELECT version_id
  FROM pruned_versions
  WHERE goes = 1
) AS surpassed ON surpassed.version_id = recorded.version_id
