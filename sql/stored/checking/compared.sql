-- Compared: rows of a state table as they are stored, and as they are made again beside the state. Both ways: a row that
-- is there once must be made once, and no other.
-- Reads:  state_rows, recomputed_rows
-- A row:  one owner of rows that differ: how many of it are stored at all, how many are stored and not made, and made
--         and not stored; since is the first time of these.
-- Slots:  :owner    the column that says whose row it is
--         :among    a condition on state_rows: those that are to be compared
--         :columns  the columns of integers and texts
--         :shares   the columns of doubles, by which not every engine groups
--         :unlike   the condition that one of these is not the same in all rows
--         :since    a time of the row, or NULL
--         :samples  how many samples it counts, or 0
SELECT
  CAST(SUM(stored_count) AS BIGINT) AS stored,
  CAST(
    SUM(
      CASE
        WHEN is_unlike = 1 THEN 1
        WHEN stored_count > recomputed_count THEN stored_count - recomputed_count
        ELSE 0
      END
    ) AS BIGINT
  ) AS only_stored,
  CAST(
    SUM(
      CASE
        WHEN is_unlike = 1 THEN 1
        WHEN recomputed_count > stored_count THEN recomputed_count - stored_count
        ELSE 0
      END
    ) AS BIGINT
  ) AS only_recomputed,
  CAST(SUM(CASE WHEN stored_count > recomputed_count THEN :samples ELSE 0 END) AS BIGINT) AS samples_then,
  CAST(SUM(CASE WHEN recomputed_count > stored_count THEN :samples ELSE 0 END) AS BIGINT) AS samples_now,
  MIN(CASE WHEN is_unlike = 1 OR stored_count <> recomputed_count THEN :since END) AS since,
  :owner AS owner_id
FROM (
  SELECT
    CAST(SUM(is_stored) AS BIGINT) AS stored_count,
    CAST(SUM(1 - is_stored) AS BIGINT) AS recomputed_count,
    CASE WHEN SUM(is_stored) = SUM(1 - is_stored) AND :unlike THEN 1 ELSE 0 END AS is_unlike,
    :columns
  FROM (
    SELECT 1 AS is_stored, :columns, :shares
    FROM state_rows
    WHERE :among
    UNION ALL
    SELECT 0 AS is_stored, :columns, :shares
    FROM recomputed_rows
  ) AS both_sides
  GROUP BY :columns
) AS matched
GROUP BY :owner
HAVING SUM(CASE WHEN is_unlike = 1 OR stored_count <> recomputed_count THEN 1 ELSE 0 END) > 0
