-- Compared: rows of a state table as they are stored, and as they are made again beside the state. Both ways: a row that
-- is there once must be made once, and no other.
-- Reads:  kept_rows, made_rows
-- A row:  one owner of rows that differ: how many of it are stored at all, how many are stored and not made, and made
--         and not stored; since is the first time of these.
-- Slots:  :owner    the column that says whose row it is
--         :among    a condition on kept_rows: those that are to be compared
--         :columns  the columns of integers and texts
--         :shares   the columns of doubles, by which not every engine groups
--         :unlike   the condition that one of these is not the same in all rows
--         :since    a time of the row, or NULL
--         :samples  how many samples it counts, or 0
SELECT
  CAST(SUM(kept_count) AS BIGINT) AS stored,
  CAST(SUM(CASE WHEN is_unlike = 1 THEN 1 WHEN kept_count > made_count THEN kept_count - made_count ELSE 0 END) AS BIGINT)
    AS only_stored,
  CAST(SUM(CASE WHEN is_unlike = 1 THEN 1 WHEN made_count > kept_count THEN made_count - kept_count ELSE 0 END) AS BIGINT)
    AS only_made,
  CAST(SUM(CASE WHEN kept_count > made_count THEN :samples ELSE 0 END) AS BIGINT) AS samples_then,
  CAST(SUM(CASE WHEN made_count > kept_count THEN :samples ELSE 0 END) AS BIGINT) AS samples_now,
  MIN(CASE WHEN is_unlike = 1 OR kept_count <> made_count THEN :since END) AS since,
  :owner AS owner_id
FROM (
  SELECT
    CAST(SUM(is_kept) AS BIGINT) AS kept_count,
    CAST(SUM(1 - is_kept) AS BIGINT) AS made_count,
    CASE WHEN SUM(is_kept) = SUM(1 - is_kept) AND :unlike THEN 1 ELSE 0 END AS is_unlike,
    :columns
  FROM (
    SELECT 1 AS is_kept, :columns, :shares
    FROM kept_rows
    WHERE :among
    UNION ALL
    SELECT 0 AS is_kept, :columns, :shares
    FROM made_rows
  ) AS both_sides
  GROUP BY :columns
) AS matched
GROUP BY :owner
HAVING SUM(CASE WHEN is_unlike = 1 OR kept_count <> made_count THEN 1 ELSE 0 END) > 0
