-- Spread: standard deviation (ddof 1) and maximum of the blocks' healthy HI about its mean, the floor.
-- Reads:  blocks, ladder
-- A row:  one support; floor_sd is NULL below two blocks.
SELECT
  support_id,
  MIN(deviations.floor) AS floor,
  MAX(healthy_hi) AS floor_max,
  CAST(SUM(deviations.vectors) AS BIGINT) AS vectors,
  CAST(COUNT(*) AS BIGINT) AS blocks,
  SQRT(
    CAST(CAST(SUM(square_units) AS BIGINT) AS DOUBLE) / MIN(units)
    / NULLIF(CAST(COUNT(*) AS DOUBLE) - CAST(1 AS DOUBLE), CAST(0 AS DOUBLE))
  ) AS floor_sd
FROM (
  SELECT
    block.support_id AS support_id,
    block.vectors AS vectors,
    block.healthy_hi AS healthy_hi,
    block.units AS units,
    grid.floor AS floor,
    CAST(
      FLOOR(
        (block.healthy_hi - grid.floor) * (block.healthy_hi - grid.floor) * block.units
        + CAST(5e-1 AS DOUBLE)
      ) AS BIGINT
    ) AS square_units
  FROM blocks AS block
  JOIN ladder AS grid ON grid.support_id = block.support_id
  WHERE grid.level = 0
) AS deviations
GROUP BY support_id
