-- Block roots: u_b of the blocks that hold a window, brought to W vectors, as a root (alarms, section 2).
-- Reads:  buffered, bounds
-- A row:  one block of one channel, for one g.
-- Slots:  :root  the expression of alarms/root.sql
SELECT channel_id, g, block, :root AS root
FROM (
  SELECT
    counted.channel_id AS channel_id,
    counted.g AS g,
    counted.block AS block,
    CAST(
      FLOOR(
        (
          CAST(2 * counted.novel_buffered * scale.window_length + counted.vectors AS DOUBLE)
          + CAST(5e-1 AS DOUBLE)
        )
        / CAST(2 * counted.vectors AS DOUBLE)
      ) AS BIGINT
    ) AS novel
  FROM buffered AS counted
  JOIN bounds AS scale ON scale.channel_id = counted.channel_id
  WHERE counted.vectors >= scale.window_length
) AS brought
