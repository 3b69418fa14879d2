-- Learnt: the calibration vectors of a channel in order, cut into blocks of W.
-- Reads:  learnable, bounds
-- A row:  one calibration vector; place numbers those of its channel from 0.
-- Slots:  :block_no  the expression of certificate/block_no.sql, of place and vectors
SELECT
  channel_id,
  support_id,
  time,
  cell_key,
  place,
  CAST(:block_no AS BIGINT) AS block_no
FROM (
  SELECT
    vector.channel_id AS channel_id,
    scale.support_id AS support_id,
    vector.time AS time,
    vector.cell_key AS cell_key,
    CAST(
      ROW_NUMBER() OVER (PARTITION BY vector.channel_id ORDER BY vector.time) AS BIGINT
    ) - 1 AS place,
    CAST(COUNT(*) OVER (PARTITION BY vector.channel_id) AS BIGINT) AS vectors
  FROM learnable AS vector
  JOIN bounds AS scale ON scale.channel_id = vector.channel_id
) AS ordered
