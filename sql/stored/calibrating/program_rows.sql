-- Program rows: what each new support knows of each program of its calibration.
-- Reads:  programs, numbering
-- A row:  one program of one support; members of a pool share theirs.
SELECT
  numbered.stored_support_id AS support_id,
  learnt.program_no AS program_no,
  learnt.program AS program,
  learnt.vectors AS vectors,
  learnt.unvouched AS unvouched,
  learnt.verdict AS verdict
FROM programs AS learnt
JOIN numbering AS numbered ON numbered.channel_id = learnt.support_id
