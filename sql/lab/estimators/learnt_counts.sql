-- Learnt counts: how many points each support can be fitted on.
-- Reads:  learnt_points
-- A row:  one support that has any.
SELECT support_id, CAST(COUNT(*) AS BIGINT) AS points
FROM learnt_points
GROUP BY support_id
ORDER BY support_id
