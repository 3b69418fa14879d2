-- Ladder: the floor on every grid of the ladder, read off the stored cells without another look at
-- the source. On a coarser grid more blocks share a cell.
-- Reads:  coarsened, levels, blocks
-- A row:  one level of one support.
SELECT
  support_id,
  level,
  level_bins,
  CAST(COUNT(*) AS BIGINT) AS blocks,
  CAST(CAST(SUM(share_units) AS BIGINT) AS DOUBLE) / (MIN(units) * CAST(COUNT(*) AS DOUBLE))
    AS floor
FROM (
  SELECT
    block.support_id AS support_id,
    step.level AS level,
    step.level_bins AS level_bins,
    block.units AS units,
    CASE
      WHEN step.level = 0 THEN block.share_units
      WHEN exclusive.hit = 1
        THEN CAST(
          FLOOR(
            CAST(exclusive.visits AS DOUBLE) / CAST(block.vectors AS DOUBLE) * block.units
            + CAST(5e-1 AS DOUBLE)
          ) AS BIGINT
        )
      ELSE 0
    END AS share_units
  FROM blocks AS block
  CROSS JOIN levels AS step
  LEFT JOIN (
    SELECT support_id, level, first_block, CAST(SUM(coarsened.visits) AS BIGINT) AS visits, 1 AS hit
    FROM coarsened
    WHERE first_block = last_block
    GROUP BY support_id, level, first_block
  ) AS exclusive
    ON exclusive.support_id = block.support_id
    AND exclusive.level = step.level
    AND exclusive.first_block = block.pool_block
) AS leveled
GROUP BY support_id, level, level_bins
