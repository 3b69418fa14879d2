-- Nearest: how far the healthy cell of the same program lies that is nearest to each of the most visited novel ones, in cells: the largest
-- step on any axis.
-- Reads:  stored_cell
-- A row:  one novel cell of a signal that has healthy ones; visit_rank is 1 for the most visited.
-- Slots:  :chosen  which versions are wanted
--         :most    novel cells of each signal
SELECT version_id, visit_rank, MIN(apart.steps) AS away
FROM (
  SELECT
    fresh.version_id AS version_id,
    fresh.visit_rank AS visit_rank,
    healthy.cell_key AS cell_key,
    MAX(ABS(fresh.code - healthy.code)) AS steps
  FROM (
    SELECT
      version_id,
      axis,
      program_no,
      code,
      CAST(
        ROW_NUMBER() OVER (PARTITION BY version_id, axis ORDER BY visits DESC, cell_key) AS BIGINT
      ) AS visit_rank
    FROM stored_cell
    WHERE kind = 'novel' AND :chosen
  ) AS fresh
  JOIN (
    SELECT version_id, cell_key, axis, program_no, code
    FROM stored_cell
    WHERE kind = 'healthy' AND :chosen
  ) AS healthy
    ON healthy.version_id = fresh.version_id
    AND healthy.axis = fresh.axis
    AND healthy.program_no = fresh.program_no
  WHERE fresh.visit_rank <= :most
  GROUP BY fresh.version_id, fresh.visit_rank, healthy.cell_key
) AS apart
GROUP BY version_id, visit_rank
