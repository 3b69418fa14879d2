-- Wanted: the versions that a scheduled run reads, each from where on and by which read of the source. A parked one
-- that sends again is read with those that are read from further back.
-- Reads:  plan, parted, resumed
-- A row:  one version.
SELECT
  frozen.version_id AS version_id,
  frozen.channel_id AS channel_id,
  frozen.asset AS asset,
  frozen.channel AS channel,
  frozen.restarts AS restarts,
  frozen.first_bucket AS first_bucket,
  frozen.read_from AS read_from,
  CASE WHEN again.hit = 1 THEN 2 ELSE part.part_no END AS part_no
FROM plan AS frozen
JOIN parted AS part ON part.version_id = frozen.version_id
LEFT JOIN (
  SELECT version_id, 1 AS hit
  FROM resumed
) AS again ON again.version_id = frozen.version_id
WHERE part.part_no > 0 OR again.hit = 1
