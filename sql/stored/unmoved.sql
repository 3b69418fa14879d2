-- Unmoved: the channels whose ranges hold as many rows as when they were read, so that none came late or went.
-- Reads:  identified, ranges
-- A row:  one channel.
SELECT channel_id
FROM (
  SELECT
    ranged.channel_id AS channel_id,
    ranged.run_id AS run_id,
    ranged.rows_read AS rows_then,
    CAST(
      SUM(CASE WHEN reading.time BETWEEN ranged.read_from AND ranged.read_to THEN 1 ELSE 0 END) AS BIGINT
    ) AS rows_now
  FROM ranges AS ranged
  JOIN identified AS reading ON reading.channel_id = ranged.channel_id
  GROUP BY ranged.channel_id, ranged.run_id, ranged.rows_read
) AS counted
GROUP BY channel_id
HAVING SUM(CASE WHEN counted.rows_now = counted.rows_then THEN 0 ELSE 1 END) = 0
