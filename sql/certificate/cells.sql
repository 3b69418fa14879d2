-- Cells: the support with what calibration knows of each cell: how often it was seen, in how many blocks, and who saw
-- it first and last.
-- Visits are grouped before blocks are looked up: DuckDB, given the join first, groups twice.
-- Reads:  visits, block_sizes
-- A row:  one cell of one support.
-- Slots:  :gathered  what the engine finds of the visits of a cell in the same pass, besides; on most nothing
--         :carried   the same, by name
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
  :carried
FROM (
  SELECT
    support_id,
    cell_key,
    CAST(SUM(visit.visits) AS BIGINT) AS visits,
    MIN(visit.place) AS first_place,
    MAX(visit.place) AS last_place,
    CAST(COUNT(*) AS BIGINT) AS visited_blocks,
    MIN(visit.first_time) AS first_time,
    MAX(visit.last_time) AS last_time,
    :gathered
  FROM (
    SELECT
      support_id,
      cell_key,
      visits,
      CAST(channel_id AS BIGINT) * CAST(2147483648 AS BIGINT) + block_no AS place,
      first_time,
      last_time
    FROM visits
  ) AS visit
  GROUP BY support_id, cell_key
) AS seen
JOIN block_sizes AS opening ON opening.place = seen.first_place
JOIN block_sizes AS closing ON closing.place = seen.last_place
