-- Program numbers: the programs of one signal that are judged, by which the readings of a piece are looked up.
-- Reads:  stored_program
-- A row:  one program.
-- Slots:  :support_id  what was learnt
SELECT program, program_no
FROM stored_program
WHERE support_id = :support_id AND verdict = 'ready'
