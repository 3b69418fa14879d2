-- Order ratios: is calibration a fair sample of what follows? The vectors in cells that stay near one block, by how many
-- there would be were blocks in random order (alarms, section 3), in thousandths, rounded half up.
-- Reads:  buffered, exclusive_cells, chances
-- A row:  one channel.
-- Slots:  :g
SELECT
  seen.channel_id AS channel_id,
  CAST(
    FLOOR(
      CAST(1000 * seen.novel_buffered AS DOUBLE)
      / CASE
        WHEN awaited.hit = 1 AND awaited.visits > CAST(1 AS DOUBLE) THEN awaited.visits
        ELSE CAST(1 AS DOUBLE)
      END
      + CAST(5e-1 AS DOUBLE)
    ) AS BIGINT
  ) AS order_ratio
FROM (
  SELECT channel_id, CAST(SUM(counted.novel_buffered) AS BIGINT) AS novel_buffered
  FROM buffered AS counted
  WHERE g = :g
  GROUP BY channel_id
) AS seen
LEFT JOIN (
  SELECT
    cell_count.channel_id AS channel_id,
    CAST(CAST(SUM(cell_count.visits * likely.chance_units) AS BIGINT) AS DOUBLE)
      / CAST(1073741824 AS DOUBLE) AS visits,
    1 AS hit
  FROM exclusive_cells AS cell_count
  JOIN chances AS likely
    ON likely.channel_id = cell_count.channel_id AND likely.visited_blocks = cell_count.visited_blocks
  GROUP BY cell_count.channel_id
) AS awaited ON awaited.channel_id = seen.channel_id
