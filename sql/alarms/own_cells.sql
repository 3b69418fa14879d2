-- Own cells: in how many of its blocks a channel visited the cells that no other member of its pool did; what the
-- order ratio expects (alarms, section 3).
-- Reads:  visits
-- A row:  one number of blocks of one channel.
SELECT
  seen.channel_id AS channel_id,
  seen.visited_blocks AS visited_blocks,
  CAST(SUM(seen.visits) AS BIGINT) AS visits
FROM (
  SELECT
    visit.channel_id AS channel_id,
    visit.cell_key AS cell_key,
    CAST(COUNT(*) AS BIGINT) AS visited_blocks,
    CAST(SUM(visit.visits) AS BIGINT) AS visits
  FROM visits AS visit
  JOIN (
    SELECT support_id, cell_key
    FROM visits
    GROUP BY support_id, cell_key
    HAVING MIN(channel_id) = MAX(channel_id)
  ) AS alone ON alone.support_id = visit.support_id AND alone.cell_key = visit.cell_key
  GROUP BY visit.channel_id, visit.cell_key
) AS seen
GROUP BY seen.channel_id, seen.visited_blocks
