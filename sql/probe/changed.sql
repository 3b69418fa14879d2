-- Changed: the cells of picked vectors after each change (Phi, method section 3).
-- Reads:  probed, usual, changes
-- A row:  one vector after one change, where all samples that it needs are there.
-- Slots:  :samples     y_0, y_1, ... the samples of a vector after a change, each by probe/sample.sql
--         :codes       code_0, code_1, ... of them
--         :is_present  all of them are there
--         :cell_key    the mixed-radix integer of the codes
SELECT support_id, block, change_no, CAST(:cell_key AS BIGINT) AS cell_key
FROM (
  SELECT support_id, block, change_no, :codes
  FROM (
    SELECT
      vector.support_id AS support_id,
      vector.block AS block,
      change.change_no AS change_no,
      middle.lo AS lo,
      middle.hi AS hi,
      :samples
    FROM probed AS vector
    JOIN usual AS middle ON middle.support_id = vector.support_id
    CROSS JOIN changes AS change
    WHERE change.pace IS NOT NULL
  ) AS moved
) AS coded
WHERE :is_present
