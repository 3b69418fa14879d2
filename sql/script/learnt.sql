-- Learnt: the vectors of calibration, in blocks of W, or in eight blocks where they are fewer.
-- Reads:  vectors
-- Slots:  :block_no  the block of a vector
--         :taught    whether calibration teaches a vector
SELECT asset, channel, time, cell_key, place, vectors, CAST(:block_no AS BIGINT) AS block
FROM (
  SELECT
    asset,
    channel,
    time,
    cell_key,
    CAST(ROW_NUMBER() OVER (PARTITION BY asset, channel ORDER BY time) AS BIGINT) - 1 AS place,
    CAST(COUNT(*) OVER (PARTITION BY asset, channel) AS BIGINT) AS vectors
  FROM vectors
  WHERE cell_key IS NOT NULL AND :taught
) AS numbered
