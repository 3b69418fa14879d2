-- Passing: the delays and grids that calibration fills, of which none may lose more than a tenth of the vectors.
-- Reads:  floors, levels, learners, usual_vectors
-- A row:  one grid of one support that passes. 2^-40 allows for the division.
-- Slots:  :target_floor
--         :least_vectors  calibration vectors below which a floor promises nothing
SELECT
  grid.support_id AS support_id,
  grid.level AS level,
  step.divisor AS divisor,
  grid.vectors AS vectors,
  CASE
    WHEN 2 * grid.floor >= grid.highest AND 2 * grid.floor >= CAST(:target_floor AS DOUBLE) THEN 2 * grid.floor
    WHEN grid.highest >= CAST(:target_floor AS DOUBLE) THEN grid.highest
    ELSE CAST(:target_floor AS DOUBLE)
  END AS hi_limit
FROM floors AS grid
JOIN levels AS step ON step.level = grid.level
JOIN (
  SELECT DISTINCT support_id, unit_id
  FROM learners
) AS learner ON learner.support_id = grid.support_id
JOIN usual_vectors AS usual ON usual.unit_id = learner.unit_id
WHERE grid.floor - CAST(:target_floor AS DOUBLE) <= CAST(1 AS DOUBLE) / CAST(1099511627776 AS DOUBLE)
  AND grid.highest <= CAST(9e-1 AS DOUBLE)
  AND grid.vectors >= :least_vectors
  AND 10 * grid.vectors >= 9 * usual.vectors
