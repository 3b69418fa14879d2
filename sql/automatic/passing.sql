-- Passing: the supports that calibration fills on one grid, by the floor and the highest block (method, section 5).
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
        FLOOR(CAST(4611686018427387904 AS DOUBLE) / CAST(size.pool_blocks AS DOUBLE)) AS units
      FROM block_sizes AS size
      JOIN coarser AS good ON good.support_id = size.support_id
      LEFT JOIN (
        SELECT first_block, CAST(SUM(cell.visits) AS BIGINT) AS visits, 1 AS hit
        FROM cells AS cell
        WHERE first_block = last_block
        GROUP BY first_block
      ) AS exclusive ON exclusive.first_block = size.pool_block
    ) AS shared
  ) AS rounded
  GROUP BY support_id
) AS measured
WHERE floor - CAST(:target_floor AS DOUBLE) <= CAST(1 AS DOUBLE) / CAST(1099511627776 AS DOUBLE)
  AND highest <= CAST(9e-1 AS DOUBLE)
