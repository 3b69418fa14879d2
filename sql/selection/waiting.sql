-- Waiting: how many reference vectors sought a neighbour in a round, and how many go on to larger boxes.
-- Reads:  rounds
-- A row:  the only one.
SELECT
  CAST(COUNT(*) AS BIGINT) AS vectors,
  CAST(SUM(CASE WHEN settled = 0 THEN 1 ELSE 0 END) AS BIGINT) AS waiting
FROM rounds
