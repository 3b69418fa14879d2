-- Visits: how often each block of calibration visited each cell.
-- Reads:  learnt
-- A row:  one cell in one block of one channel.
SELECT
  channel_id,
  support_id,
  block_no,
  cell_key,
  CAST(COUNT(*) AS BIGINT) AS visits,
  MIN(time) AS first_time,
  MAX(time) AS last_time
FROM learnt
GROUP BY channel_id, support_id, block_no, cell_key
