-- Tails: where the newest buckets of each version are. The newest run that found rows wrote all that is visible
-- from its first bucket on, and the bucket before that was there; so nobody has to look further back.
-- Reads:  stored_run
-- A row:  one version that was scored.
SELECT version_id, from_bucket - 1 AS tail_from
FROM (
  SELECT
    finished.version_id AS version_id,
    finished.from_bucket AS from_bucket,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY finished.version_id ORDER BY finished.run_id DESC) AS BIGINT
    ) AS runs_back
  FROM stored_run AS finished
  WHERE finished.from_bucket < 4611686018427387904
) AS ranked
WHERE runs_back = 1
