-- Judged programs, stored form: those of which the calibration of a group of channels holds enough.
-- Reads:  stored_program, cohort
-- A row:  one program of one support.
SELECT learnt.support_id AS support_id, learnt.program AS program, learnt.program_no AS program_no
FROM stored_program AS learnt
JOIN (
  SELECT support_id
  FROM cohort
  GROUP BY support_id
) AS needed ON needed.support_id = learnt.support_id
WHERE learnt.verdict = 'ready'
