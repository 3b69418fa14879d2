-- Failing: a statement that ends a script with an error where a query has a row.
-- Reads:  problems
-- A row:  the only one.
-- Slots:  :failure  by problem_rows: what fails if it is computed
SELECT CASE WHEN counted.problem_rows > 0 THEN :failure END AS verified
FROM (
  SELECT CAST(COUNT(*) AS BIGINT) AS problem_rows
  FROM problems
) AS counted
