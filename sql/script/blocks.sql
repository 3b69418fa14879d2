-- Blocks: on each grid, the vectors of a block that lie in cells which no other block visits.
-- Reads:  levels, visits, coarsened
SELECT
  size.asset AS asset,
  size.channel AS channel,
  step.level AS level,
  step.level_bins AS level_bins,
  size.block AS block,
  size.first_time AS first_time,
  size.last_time AS last_time,
  size.vectors AS vectors,
  CASE WHEN exclusive.hit = 1 THEN exclusive.novel ELSE 0 END AS novel,
  CAST(CASE WHEN exclusive.hit = 1 THEN exclusive.novel ELSE 0 END AS DOUBLE) / CAST(size.vectors AS DOUBLE)
    AS healthy_hi,
  FLOOR(
    CAST(4611686018427387904 AS DOUBLE)
    / CAST(COUNT(*) OVER (PARTITION BY size.asset, size.channel, step.level) AS DOUBLE)
  ) AS units
FROM (
  SELECT
    asset,
    channel,
    block,
    CAST(SUM(visits) AS BIGINT) AS vectors,
    MIN(visit.first_time) AS first_time,
    MAX(visit.last_time) AS last_time
  FROM visits AS visit
  GROUP BY asset, channel, block
) AS size
CROSS JOIN levels AS step
LEFT JOIN (
  SELECT asset, channel, level, block, CAST(SUM(visits) AS BIGINT) AS novel, 1 AS hit
  FROM coarsened
  WHERE block = last_block
  GROUP BY asset, channel, level, block
) AS exclusive
  ON exclusive.asset = size.asset
  AND exclusive.channel = size.channel
  AND exclusive.level = step.level
  AND exclusive.block = size.block
