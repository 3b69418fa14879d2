-- Floors: the floor and the highest block of calibration on every grid that is compared (method, section 5).
-- Reads:  block_sizes, grids, levels
-- A row:  one grid of one support.
SELECT
  support_id,
  level,
  CAST(SUM(leveled.vectors) AS BIGINT) AS vectors,
  CAST(CAST(SUM(share_units) AS BIGINT) AS DOUBLE) / (MIN(units) * CAST(COUNT(*) AS DOUBLE)) AS floor,
  MAX(share) AS highest
FROM (
  SELECT
    support_id,
    level,
    vectors,
    share,
    units,
    CAST(FLOOR(share * units + CAST(5e-1 AS DOUBLE)) AS BIGINT) AS share_units
  FROM (
    SELECT
      size.support_id AS support_id,
      step.level AS level,
      size.vectors AS vectors,
      CASE
        WHEN exclusive.hit = 1 THEN CAST(exclusive.visits AS DOUBLE) / CAST(size.vectors AS DOUBLE)
        ELSE CAST(0 AS DOUBLE)
      END AS share,
      FLOOR(CAST(4611686018427387904 AS DOUBLE) / CAST(size.pool_blocks AS DOUBLE)) AS units
    FROM block_sizes AS size
    CROSS JOIN levels AS step
    LEFT JOIN (
      SELECT support_id, level, first_block, CAST(SUM(cell.visits) AS BIGINT) AS visits, 1 AS hit
      FROM grids AS cell
      WHERE first_block = last_block
      GROUP BY support_id, level, first_block
    ) AS exclusive
      ON exclusive.support_id = size.support_id
      AND exclusive.level = step.level
      AND exclusive.first_block = size.pool_block
  ) AS shared
) AS leveled
GROUP BY support_id, level
