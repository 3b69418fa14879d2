-- Waiting: how many reference vectors go on to larger boxes.
-- Reads:  rounds
-- A row:  the only one.
SELECT CAST(COUNT(*) AS BIGINT) AS vectors
FROM rounds
WHERE settled = 0
