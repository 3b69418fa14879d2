-- Judged programs: those of which calibration holds enough (both sides, section 5).
-- Reads:  programs
-- A row:  one program of one support.
SELECT support_id, program, program_no
FROM programs
WHERE verdict = 'ready'
