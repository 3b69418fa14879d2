-- Exclusive cells: in how many of its blocks a channel visited the cells that no other member of its pool visited. The
-- order ratio needs them (alarms, section 3).
-- Reads:  cells
-- A row:  one number of blocks of one channel.
SELECT
  cell.first_channel AS channel_id,
  cell.visited_blocks AS visited_blocks,
  CAST(SUM(cell.visits) AS BIGINT) AS visits
FROM cells AS cell
WHERE cell.first_channel = cell.last_channel
GROUP BY cell.first_channel, cell.visited_blocks
