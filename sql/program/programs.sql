-- Programs: what calibration knows of each program: how many vectors it holds, and how many of them only their own
-- block vouches for (both sides, section 5). One with few vectors, or too many such, is not judged.
-- Reads:  taught_programs, bounds, cells
-- A row:  one program of one support.
-- Slots:  :weight         R^m, with R = bins + 3
--         :least_vectors  vectors below which a program is not judged
SELECT
  ran.support_id AS support_id,
  ran.program_no AS program_no,
  ran.program AS program,
  CASE WHEN learnt.hit = 1 THEN learnt.vectors ELSE CAST(0 AS BIGINT) END AS vectors,
  CASE WHEN learnt.hit = 1 THEN learnt.unvouched ELSE CAST(0 AS BIGINT) END AS unvouched,
  CASE
    WHEN learnt.hit = 1
      AND learnt.vectors >= :least_vectors
      AND CAST(learnt.unvouched AS DOUBLE) / CAST(learnt.vectors AS DOUBLE) <= scale.target_floor
      THEN 'ready'
    ELSE 'needs_data'
  END AS verdict
FROM taught_programs AS ran
JOIN (
  SELECT edge.support_id AS support_id, MIN(edge.target_floor) AS target_floor
  FROM bounds AS edge
  GROUP BY edge.support_id
) AS scale ON scale.support_id = ran.support_id
LEFT JOIN (
  SELECT
    support_id,
    program_no,
    CAST(SUM(program_cell.visits) AS BIGINT) AS vectors,
    CAST(
      SUM(CASE WHEN program_cell.first_block = program_cell.last_block THEN program_cell.visits ELSE 0 END) AS BIGINT
    ) AS unvouched,
    1 AS hit
  FROM (
    SELECT
      support_id,
      CAST(
        FLOOR(CAST(cell_key - cell_key % :weight AS DOUBLE) / CAST(:weight AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS BIGINT
      ) AS program_no,
      visits,
      first_block,
      last_block
    FROM cells
  ) AS program_cell
  GROUP BY support_id, program_no
) AS learnt ON learnt.support_id = ran.support_id AND learnt.program_no = ran.program_no
