-- Relearnt: the cells that the frozen intervals of calibration would teach now, beside those that were learnt.
-- Reads:  learnable, cohort, stored_support
-- A row:  one support of which a cell is visited otherwise.
SELECT
  matched.support_id AS support_id,
  CAST(COUNT(*) AS BIGINT) AS differing
FROM (
  SELECT
    visited.support_id AS support_id,
    visited.cell_key AS cell_key,
    CAST(SUM(visited.visits) AS BIGINT) AS gained
  FROM (
    SELECT member.support_id AS support_id, vector.cell_key AS cell_key, 1 AS visits
    FROM learnable AS vector
    JOIN cohort AS member ON member.channel_id = vector.channel_id
    UNION ALL
    SELECT cell.support_id AS support_id, cell.cell_key AS cell_key, 0 - cell.visits AS visits
    FROM stored_support AS cell
    JOIN (
      SELECT support_id
      FROM cohort
      GROUP BY support_id
    ) AS needed ON needed.support_id = cell.support_id
  ) AS visited
  GROUP BY visited.support_id, visited.cell_key
) AS matched
WHERE matched.gained <> 0
GROUP BY matched.support_id
