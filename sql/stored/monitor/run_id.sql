-- Run id: the number of this run.
-- Reads:  stamp
-- A row:  the only one.
SELECT stamp.run_id AS run_id
FROM stamp
