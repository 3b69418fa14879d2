-- Probe: of how many picked vectors each change would leave the cells that calibration visited; as everywhere, a cell
-- that no other block visited counts as novel (both sides, section 2).
-- Reads:  changed, cells, changes, usual
-- A row:  one change of one support; vectors and novel are NULL where it cannot be asked.
SELECT
  middle.support_id AS support_id,
  change.change_no AS change_no,
  change.change_name AS change_name,
  CASE
    WHEN counted.hit = 1 THEN counted.vectors
    WHEN change.pace IS NOT NULL THEN CAST(0 AS BIGINT)
  END AS vectors,
  CASE
    WHEN counted.hit = 1 THEN counted.novel
    WHEN change.pace IS NOT NULL THEN CAST(0 AS BIGINT)
  END AS novel
FROM usual AS middle
CROSS JOIN changes AS change
LEFT JOIN (
  SELECT
    vector.support_id AS support_id,
    vector.change_no AS change_no,
    CAST(COUNT(*) AS BIGINT) AS vectors,
    CAST(
      SUM(
        CASE
          WHEN healthy.hit = 1 AND (healthy.first_block < healthy.last_block OR healthy.first_block <> vector.block)
            THEN 0
          ELSE 1
        END
      ) AS BIGINT
    ) AS novel,
    1 AS hit
  FROM changed AS vector
  LEFT JOIN (
    SELECT support_id, cell_key, first_block, last_block, 1 AS hit
    FROM cells
  ) AS healthy ON healthy.support_id = vector.support_id AND healthy.cell_key = vector.cell_key
  GROUP BY vector.support_id, vector.change_no
) AS counted ON counted.support_id = middle.support_id AND counted.change_no = change.change_no
