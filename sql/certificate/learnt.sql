-- Learnt: the calibration vectors of a channel in order, cut into blocks of W; the short rest joins
-- the last block. Where that gives fewer than 8 blocks, block = floor(8 i / n) (method, section 5).
-- Reads:  learnable, bounds
-- A row:  one calibration vector.
-- Slots:  :window  W, in vectors
SELECT
  channel_id,
  support_id,
  time,
  cell_key,
  CAST(
    CASE
      WHEN window_blocks < 8
        THEN FLOOR((CAST(8 * place AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(vectors AS DOUBLE))
      WHEN window_block >= window_blocks THEN window_blocks - 1
      ELSE window_block
    END AS BIGINT
  ) AS block_no
FROM (
  SELECT
    channel_id,
    support_id,
    time,
    cell_key,
    place,
    vectors,
    FLOOR((CAST(place AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:window AS DOUBLE)) AS window_block,
    FLOOR((CAST(vectors AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(:window AS DOUBLE))
      AS window_blocks
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
) AS cut
