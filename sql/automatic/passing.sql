-- Passing: the supports that calibration fills on one grid, by the floor and the highest block, or machine (method,
-- section 5; both sides, section 6).
-- Reads:  block_sizes, cells, coarser
-- A row:  one support that passes. 2^-40 allows for the division.
-- Slots:  :level, :divisor  the number of the grid, and how many bins of the finest one make one of it
--         :target_floor
SELECT
  support_id,
  CAST(:level AS INTEGER) AS level,
  CAST(:divisor AS DOUBLE) AS divisor,
  CASE
    WHEN 2 * floor >= highest AND 2 * floor >= CAST(:target_floor AS DOUBLE) THEN 2 * floor
    WHEN highest >= CAST(:target_floor AS DOUBLE) THEN highest
    ELSE CAST(:target_floor AS DOUBLE)
  END AS hi_limit
FROM (
  SELECT
    support_id,
    CAST(CAST(SUM(share_units) AS BIGINT) AS DOUBLE) / (MIN(units) * CAST(COUNT(*) AS DOUBLE)) AS floor,
    MAX(share) AS highest
  FROM (
    SELECT
      support_id,
      share,
      units,
      CAST(FLOOR(share * units + CAST(5e-1 AS DOUBLE)) AS BIGINT) AS share_units
    FROM (
      SELECT
        size.support_id AS support_id,
        CASE
          WHEN exclusive.hit = 1 THEN CAST(exclusive.visits AS DOUBLE) / CAST(size.vectors AS DOUBLE)
          ELSE CAST(0 AS DOUBLE)
        END AS share,
        FLOOR(CAST(4611686018427387904 AS DOUBLE) / CAST(size.parts AS DOUBLE)) AS units
      FROM (
        SELECT
          support_id,
          part,
          CAST(SUM(block.vectors) AS BIGINT) AS vectors,
          CAST(COUNT(*) OVER (PARTITION BY support_id) AS BIGINT) AS parts
        FROM block_sizes AS block
        GROUP BY support_id, part
      ) AS size
      JOIN coarser AS good ON good.support_id = size.support_id
      LEFT JOIN (
        SELECT first_part, CAST(SUM(cell.visits) AS BIGINT) AS visits, 1 AS hit
        FROM cells AS cell
        WHERE first_part = last_part
        GROUP BY first_part
      ) AS exclusive ON exclusive.first_part = size.part
    ) AS shared
  ) AS rounded
  GROUP BY support_id
) AS measured
WHERE floor - CAST(:target_floor AS DOUBLE) <= CAST(1 AS DOUBLE) / CAST(1099511627776 AS DOUBLE)
  AND highest <= CAST(9e-1 AS DOUBLE)
