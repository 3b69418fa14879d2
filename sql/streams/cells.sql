-- Cells, of visits in stored order: the support, with what calibration knows of each cell (certificate/cells.sql), and
-- how often its first block visited it, and which block came second. DuckDB finds these in the same pass; other engines
-- look at visits again (certificate/cell_shares.sql).
-- Reads:  visits, block_sizes
-- A row:  one cell of one support; second_place is NULL where only one block saw it.
SELECT
  seen.support_id AS support_id,
  seen.cell_key AS cell_key,
  seen.visits AS visits,
  opening.pool_block AS first_block,
  closing.pool_block AS last_block,
  seen.visited_blocks AS visited_blocks,
  opening.channel_id AS first_channel,
  closing.channel_id AS last_channel,
  seen.first_time AS first_time,
  seen.last_time AS last_time,
  seen.first_visits AS first_visits,
  seen.second_place AS second_place
FROM (
  SELECT
    support_id,
    cell_key,
    CAST(SUM(visit.visits) AS BIGINT) AS visits,
    MIN(CAST(visit.channel_id AS BIGINT) * CAST(2147483648 AS BIGINT) + visit.block_no, 2)[1] AS first_place,
    MIN(CAST(visit.channel_id AS BIGINT) * CAST(2147483648 AS BIGINT) + visit.block_no, 2)[2] AS second_place,
    MAX(CAST(visit.channel_id AS BIGINT) * CAST(2147483648 AS BIGINT) + visit.block_no) AS last_place,
    ARG_MIN(visit.visits, CAST(visit.channel_id AS BIGINT) * CAST(2147483648 AS BIGINT) + visit.block_no)
      AS first_visits,
    CAST(COUNT(*) AS BIGINT) AS visited_blocks,
    MIN(visit.first_time) AS first_time,
    MAX(visit.last_time) AS last_time
  FROM visits AS visit
  GROUP BY support_id, cell_key
) AS seen
JOIN block_sizes AS opening ON opening.place = seen.first_place
JOIN block_sizes AS closing ON closing.place = seen.last_place
