-- Oldest buckets: where the buckets and the judgements of each version of a monitor begin. Pruning may have left more
-- judgements than buckets.
-- Reads:  checked, stored_visible_bucket, stored_visible_judgement
-- A row:  one version that has a bucket; oldest_judgement is NULL where nothing is judged.
SELECT
  version.version_id AS version_id,
  begun.oldest_bucket AS oldest_bucket,
  CASE WHEN judged.hit = 1 THEN judged.oldest_judgement END AS oldest_judgement
FROM checked AS version
JOIN (
  SELECT version_id, MIN(bucket_no) AS oldest_bucket
  FROM stored_visible_bucket
  GROUP BY version_id
) AS begun ON begun.version_id = version.version_id
LEFT JOIN (
  SELECT version_id, MIN(judgement_no) AS oldest_judgement, 1 AS hit
  FROM stored_visible_judgement
  GROUP BY version_id
) AS judged ON judged.version_id = version.version_id
